#pragma once

#include <optional>

#include "raster/coverage/cell_coverage.hpp"
#include "raster/coverage/clip.hpp"
#include "raster/kernels/pixel_mask.hpp"
#include "raster/kernels/placed_triangles.hpp"

namespace sfumato::raster {

/// One of the placed triangles.
struct Placed {
  Placed(const PlacedTriangles& all, std::size_t i)
      : box{{all.left[i], all.top[i]}, {all.right[i], all.bottom[i]}},
        range{all.begin[i], all.end[i], all.first_row[i], all.end_row[i]} {
    for (int k = 0; k < 3; ++k) corner[k] = {all.x[k][i], all.y[k][i]};
  }

  Vec2 corner[3];
  Box box;
  PixelRange range;
};

/// The parts of a triangle in unit squares.
class TriangleParts {
 public:
  /// Prepares a triangle. Its corners are clockwise on the screen, unless the layer is mirrored; it
  /// uses `cells` as its workspace.
  TriangleParts(const Placed& placed, bool mirrored, double scale, CellCoverage* cells)
      : cells_(cells) {
    const Vec2 a = placed.corner[0] * scale;
    const Vec2 b = placed.corner[mirrored ? 2 : 1] * scale;
    const Vec2 c = placed.corner[mirrored ? 1 : 2] * scale;
    if (!cells_->cut({a, b, c}, {placed.box.min * scale, placed.box.max * scale})) {
      cells_ = nullptr;
      clip_ = clip_triangle(a, b, c);
    }
  }

  Coverage in(int x, int y) const {
    return cells_ ? cells_->in(x, y) : pixel_coverage(*clip_, x, y);
  }
  /// Returns the part of a pixel's quarter, as a part of a pixel, for a triangle of double size.
  Coverage in_quarter(int x, int y, int quarter) const {
    const Vec2 corner{1.0 * (quarter & 1), 1.0 * (quarter >> 1)};
    const Coverage part = in(2 * x + (quarter & 1), 2 * y + (quarter >> 1));
    if (part.area == 0) return {};
    return {0.25 * part.area, 0.5 * (corner + part.centroid)};
  }

 private:
  CellCoverage* cells_;  ///< null: not small
  std::optional<ClipTriangle> clip_;
};

}  // namespace sfumato::raster
