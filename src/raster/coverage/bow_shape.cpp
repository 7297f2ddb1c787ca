#include "raster/coverage/bow_shape.hpp"

#include <algorithm>
#include <cmath>

#include "curves/flatten.hpp"
#include "raster/coverage/square_integral.hpp"
#include "raster/kernels/triangle_frame.hpp"

namespace sfumato::raster {
namespace {

/// The largest distance of the curve's parts from the parabola, pixels.
constexpr double kPartPx = 0.01;

/// The distance from a pixel's centre to its corners, rounded up.
constexpr double kHalfDiagonal = 0.70711;

int part_count(double bend_px) {
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(bend_px / kPartPx))), 1,
                    BowShape::kMostParts);
}

}  // namespace

double largest_height(const CurveBow& bow) {
  // Between its ends a parabola is at most a quarter of its bend beyond them.
  const auto [low, high] = std::minmax({bow.height[0], bow.height[1], bow.height[2]});
  const double bend = std::fabs(bow.height[1] - 0.5 * (double{bow.height[0]} + bow.height[2]));
  return std::max(std::fabs(double{low}), std::fabs(double{high})) + 0.25 * bend;
}

BowShape bow_shape(const LayerView& layer, const CurveBow& bow) {
  BowShape shape;
  shape.edge = painted_edge(layer, bow);
  const EdgeSlots slots = slots_of(bow);
  const Vec2 along = corner_in_layer(layer, slots.to) - corner_in_layer(layer, slots.from);
  const Vec2 normal = vector_in_image(layer, Vec2{-along.y, along.x} / length(along));
  const double bend = bow.height[1] - 0.5 * (double{bow.height[0]} + bow.height[2]);
  const curves::ChordBow heights{bow.height[0], bow.height[1], bow.height[2]};
  const int parts = part_count(std::fabs(bend) * length(normal));
  shape.reach = largest_height(bow) * length(normal);
  shape.corner[0] = shape.edge.end[0];
  shape.corner[1] = shape.edge.end[1];
  for (int i = 0; i <= parts; ++i) {
    const double u = 1 - i / static_cast<double>(parts);
    shape.corner[2 + i] = lerp(shape.edge.end[0], shape.edge.end[1], u) + normal * heights.at(u);
  }
  shape.corner_count = parts + 3;
  return shape;
}

StripPart bow_part(const BowShape& shape, int x, int y) {
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  const Vec2 along = shape.edge.end[1] - shape.edge.end[0];
  const Vec2 center = origin + Vec2{0.5, 0.5} - shape.edge.end[0];
  StripPart part;
  const double square = dot(along, along), beside = cross(along, center);
  const double most = shape.reach + kHalfDiagonal;
  if (beside * beside > most * most * square) return part;
  Moments sum;
  Vec2 last = shape.corners().back() - origin;
  for (const Vec2 corner : shape.corners()) {
    const Vec2 next = corner - origin;
    sum.add(edge_integral(last, next), shape.edge.turn);
    last = next;
  }
  std::ranges::fill(part.area, static_cast<float>(sum.area));
  part.moment[0] = static_cast<float>(sum.x);
  part.moment[1] = static_cast<float>(sum.y);
  part.along = static_cast<float>(clamp_unit(dot(center, along) / square));
  return part;
}

}  // namespace sfumato::raster
