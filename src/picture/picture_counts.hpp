#pragma once

#include <cstdint>

#include "sfumato/picture/picture.hpp"

namespace sfumato::picture {

/// The sizes of the tables of all layers of a picture together.
struct PictureCounts {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::uint64_t nodes = 0;  ///< including nodes of opacity
};

PictureCounts count_tables(const Picture& picture);

/// Returns the number of points at which exact fields were read so far to draw the picture.
std::uint64_t count_read_points(const Picture& picture);

}  // namespace sfumato::picture
