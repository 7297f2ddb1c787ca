#pragma once

#include <algorithm>
#include <cmath>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// Texels that cover a box. Each is a pixel of the picture, or larger if there would be too many.
struct TexelGrid {
  int width = 0, height = 0;  ///< texels, above 0
  Affine frame_from_texture;

  std::size_t count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// Returns the box of all texels in the frame.
  Box box() const {
    return {frame_from_texture({0, 0}), frame_from_texture({double(width), double(height)})};
  }
};

/// Returns the texels over a box and a margin of one texel.
/// corner           of a pixel of the picture
/// units_per_texel  of the picture's own size
/// side             the largest width and height
inline TexelGrid texel_grid(const Box& box, Vec2 corner, double units_per_texel, int side) {
  constexpr double kSameEdge =
      1e-6;  ///< a share of a texel: an edge this near to a texel's edge counts as equal
  const auto along = [&](double low, double high, double origin, double& begin, double& size) {
    begin = std::floor((low - origin) / units_per_texel + kSameEdge) - 1;
    const double count =
        std::max(1.0, std::ceil((high - origin) / units_per_texel - kSameEdge) + 1 - begin);
    begin = origin + begin * units_per_texel;
    const double texels = std::min(count, double(side));
    size = count * units_per_texel / texels;
    return static_cast<int>(texels);
  };
  TexelGrid grid;
  Vec2 begin, size;
  grid.width = along(box.min.x, box.max.x, corner.x, begin.x, size.x);
  grid.height = along(box.min.y, box.max.y, corner.y, begin.y, size.y);
  grid.frame_from_texture = {size.x, 0, 0, size.y, begin.x, begin.y};
  return grid;
}

}  // namespace sfumato::svg
