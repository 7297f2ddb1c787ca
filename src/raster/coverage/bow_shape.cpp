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

Vec2 edge_point(const BowShape& shape, double u) {
  return lerp(shape.edge.end[0], shape.edge.end[1], u);
}

Vec2 curve_point(const BowShape& shape, double u) {
  return edge_point(shape, u) + shape.normal * shape.height.at(u);
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
  shape.normal = normal;
  shape.height = {bow.height[0], bow.height[1], bow.height[2]};
  shape.bend = std::fabs(bend) * length(normal);
  const int parts = part_count(shape.bend);
  shape.reach = largest_height(bow) * length(normal);
  shape.corner[0] = shape.edge.end[0];
  shape.corner[1] = shape.edge.end[1];
  for (int i = 0; i <= parts; ++i) {
    const double u = 1 - i / static_cast<double>(parts);
    shape.corner[2 + i] = curve_point(shape, u);
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
  // Integrate only the part of the bow that may lie in the pixel.
  const double middle = dot(center, along) / square, half = most / std::sqrt(square);
  const double from = std::max(middle - half, 0.0), to = std::min(middle + half, 1.0);
  if (from >= to) return part;
  const int parts = part_count(shape.bend * (to - from) * (to - from));
  Moments sum;
  const Vec2 start = edge_point(shape, from) - origin;
  Vec2 last = start;
  const auto add_edge_to = [&](Vec2 next) {
    sum.add(edge_integral(last, next), shape.edge.turn);
    last = next;
  };
  add_edge_to(edge_point(shape, to) - origin);
  for (int i = 0; i <= parts; ++i)
    add_edge_to(curve_point(shape, to + (from - to) * i / parts) - origin);
  add_edge_to(start);
  std::ranges::fill(part.area, static_cast<float>(sum.area));
  part.moment[0] = static_cast<float>(sum.x);
  part.moment[1] = static_cast<float>(sum.y);
  part.along = static_cast<float>(clamp_unit(middle));
  return part;
}

}  // namespace sfumato::raster
