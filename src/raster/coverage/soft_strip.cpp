#include "raster/coverage/soft_strip.hpp"

#include <algorithm>
#include <cmath>

#include "raster/coverage/square_integral.hpp"

namespace sfumato::raster {
SoftStrip soft_strip(const LayerView& layer, const SoftEdge& edge) {
  const auto reach = [&](Vec2 r) {
    const Vec2 px = vector_in_image(layer, r);
    const double size = length(px);
    return size > kMostReachPx ? px * (kMostReachPx / size) : px;
  };
  return {painted_edge(layer, edge), {reach(edge.reach[0]), reach(edge.reach[1])}};
}

StripPart strip_part(const SoftStrip& strip, int x, int y) {
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  const Vec2 from = strip.edge.end[0] - origin, to = strip.edge.end[1] - origin;
  const Moments edge = edge_integral(from, to);
  StripPart part;
  Moments sum;
  for (int i = 0; i < kStrips; ++i) {
    const Vec2 far_from = from + strip.reach[0] * kStripReach[i];
    const Vec2 far_to = to + strip.reach[1] * kStripReach[i];
    sum = edge;
    sum.add(edge_integral(to, far_to), 1);
    sum.add(edge_integral(far_to, far_from), 1);
    sum.add(edge_integral(far_from, from), 1);
    part.area[i] = static_cast<float>(strip.edge.turn * sum.area);
  }
  // Smaller areas are rounding errors of the edges' sum.
  constexpr double kLeastRemainder = 1e-9;
  if (std::fabs(sum.area) < kLeastRemainder) return {};
  const Vec2 along = to - from;
  const double place = dot(Vec2{sum.x, sum.y} / sum.area - from, along) / dot(along, along);
  part.along = static_cast<float>(place > 0 ? std::min(place, 1.0) : 0);
  return part;
}

}  // namespace sfumato::raster
