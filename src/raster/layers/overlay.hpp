#pragma once

#include <vector>

#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// The distance from an edge up to which the overlay paints, in pixels.
inline constexpr double kOverlayReachPx = 1.5;

/// The lines of triangulations over one tile: thin for free edges, in black or white, whichever
/// contrasts more; thicker and orange for edges on curves. A line is antialiased by its distance to
/// a pixel's centre, and edges that overlap do not add up.
class Overlay {
 public:
  /// Removes all lines.
  void clear();
  void add(const LayerView& layer, const TriangleList& triangles, const Tile& tile);
  void paint(const Tile& tile) const;

 private:
  void add_edge(Vec2 a, Vec2 b, bool is_curve, const Tile& tile);

  std::vector<float> free_;   ///< share of ink, kTileFloats
  std::vector<float> curve_;  ///< the same for curves
};

}  // namespace sfumato::raster
