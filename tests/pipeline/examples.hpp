#pragma once

#include <string>

#include "support/folder_files.hpp"
#include "support/places.hpp"

namespace sfumato::test {

inline const std::string kExamplesFolder = source_path("examples/");

/// Textures beside the examples.
inline FolderFiles example_textures() {
  return FolderFiles(kExamplesFolder);
}

}  // namespace sfumato::test
