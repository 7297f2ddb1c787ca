#pragma once

#include <string>

#include "formats/read_document.hpp"

namespace sfumato::cli {

/// Reads the files that a document names relative to its own folder (".." is allowed; absolute
/// paths are refused, and what is not a regular file).
class FolderLoader final : public ResourceLoader {
 public:
  /// The path of the document; "-" is standard input: the current folder.
  explicit FolderLoader(const std::string& document);

  Result<std::vector<std::uint8_t>> load(std::string_view href) const override;

 private:
  std::string folder_;
};

}  // namespace sfumato::cli
