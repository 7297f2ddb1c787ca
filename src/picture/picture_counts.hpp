#pragma once

#include <cstdint>

#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// What the tables of all layers of a picture hold together.
struct PictureCounts {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t nodes = 0;  ///< with those of opacity
};

PictureCounts count_tables(const Picture& picture);

}  // namespace sfumato::picture
