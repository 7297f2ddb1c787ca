#pragma once

#include <span>

#include "curves/flatten.hpp"
#include "raster/coverage/painted_edge.hpp"
#include "raster/coverage/soft_strip.hpp"

namespace sfumato::raster {

/// A bow that is nowhere higher than this shows in no pixel.
inline constexpr double kLeastBowPx = 0.02;

/// Returns the largest distance of the curve from its edge, in the layer's frame.
double largest_height(const CurveBow& bow);

/// The area between an edge and its curve in the image, as a polygon.
struct BowShape {
  static constexpr int kMostParts = 8;

  PaintedEdge edge;
  Vec2 normal;              ///< of the edge, for a height of 1
  curves::ChordBow height;  ///< of the curve
  double bend = 0;   ///< distance of the curve in the middle from the line between its ends, pixels
  double reach = 0;  ///< no point of the polygon is farther from the line through the edge
  Vec2 corner[2 + kMostParts + 1];  ///< the edge's ends, then the curve back from its end
  int corner_count = 0;

  std::span<const Vec2> corners() const { return {corner, static_cast<std::size_t>(corner_count)}; }
};

/// Returns the shape of a bow. The polygon lies within 0.01 pixels of the parabola at the
/// resolution that the picture was made for.
BowShape bow_shape(const LayerView& layer, const CurveBow& bow);

/// Returns the part of a bow in a pixel. All its areas are the area between edge and curve,
/// positive where the curve lies on the side of the front; `along` is the place on the edge that is
/// nearest to the pixel's centre.
StripPart bow_part(const BowShape& shape, int x, int y);

}  // namespace sfumato::raster
