#include "raster/coverage/soft_strip.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "base/half_edge.hpp"

namespace sfumato::raster {
namespace {

/// Blurs finer than the pixels that a picture was made for extend farther only where the picture is
/// enlarged; no blur may make a tile test all triangles.
constexpr double kMostReachPx = 64;

/// Integrals of dx dy, x dx dy and y dx dy.
struct Moments {
  double area = 0, x = 0, y = 0;

  void add(const Moments& other, double sign) {
    area += sign * other.area;
    x += sign * other.x;
    y += sign * other.y;
  }
};

/// Integrates over the area left of the line from a to b, by Green's theorem: x dy, x² / 2 dy and x
/// y dy along it.
Moments line_integral(Vec2 a, Vec2 b) {
  const double dy = b.y - a.y;
  return {0.5 * dy * (a.x + b.x), dy * (a.x * (a.x + b.x) + b.x * b.x) / 6,
          dy * (a.x * (2 * a.y + b.y) + b.x * (a.y + 2 * b.y)) / 6};
}

/// Finds the range on the line from p, which grows by `change`, inside the square [0, 1].
void square_range(double p, double change, double (&range)[2]) {
  range[0] = 0;
  range[1] = 1;
  if (change == 0) return;
  const double low = std::clamp(-p / change, 0.0, 1.0);
  const double high = std::clamp((1 - p) / change, 0.0, 1.0);
  range[0] = std::min(low, high);
  range[1] = std::max(low, high);
}

Vec2 in_square(Vec2 p) {
  return {std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)};
}

/// Does the same for an edge whose points are moved to the nearest of the square [0, 1]²: summed
/// over a polygon's edges this is the integral over its part of the square.
Moments edge_integral(Vec2 a, Vec2 b) {
  Moments sum;
  const bool is_beside = (a.y <= 0 && b.y <= 0) || (a.y >= 1 && b.y >= 1);
  if (is_beside || a.y == b.y || (a.x <= 0 && b.x <= 0)) return sum;
  const Vec2 from = in_square(a), to = in_square(b);
  if ((from == a && to == b) || (a.x >= 1 && b.x >= 1)) return line_integral(from, to);
  double rows[2], columns[2];
  square_range(a.y, b.y - a.y, rows);
  const Vec2 p = lerp(a, b, rows[0]), q = lerp(a, b, rows[1]);
  square_range(p.x, q.x - p.x, columns);
  const Vec2 m = in_square(lerp(p, q, columns[0])), n = in_square(lerp(p, q, columns[1]));
  sum.add(line_integral(in_square(p), m), 1);
  sum.add(line_integral(m, n), 1);
  sum.add(line_integral(n, in_square(q)), 1);
  return sum;
}

}  // namespace

SoftStrip soft_strip(const LayerView& layer, const SoftEdge& edge) {
  const bool is_front = edge.front != SoftEdge::kNone;
  const std::uint32_t slot = is_front ? edge.front : edge.back;
  const std::uint32_t next = next_half_edge(slot);
  const auto corner = [&](std::uint32_t s) {
    return layer.image_from_layer(layer.vertex_position[layer.triangle_vertex[s]]);
  };
  const auto reach = [&](Vec2 r) {
    const Affine& m = layer.image_from_layer;
    const Vec2 px{m.a * r.x + m.c * r.y, m.b * r.x + m.d * r.y};
    const double size = length(px);
    return size > kMostReachPx ? px * (kMostReachPx / size) : px;
  };
  return {{corner(is_front ? slot : next), corner(is_front ? next : slot)},
          {reach(edge.reach[0]), reach(edge.reach[1])},
          layer.mirrored ? -1.0 : 1.0};
}

StripPart strip_part(const SoftStrip& strip, int x, int y) {
  const Vec2 origin{static_cast<double>(x), static_cast<double>(y)};
  const Vec2 from = strip.end[0] - origin, to = strip.end[1] - origin;
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
    part.area[i] = static_cast<float>(strip.turn * sum.area);
  }
  // Smaller areas are rounding errors of the edges' sum.
  constexpr double kLeastRemainder = 1e-9;
  if (std::fabs(sum.area) < kLeastRemainder) return {};
  const Vec2 along = to - from;
  const double place = dot(Vec2{sum.x, sum.y} / sum.area - from, along) / dot(along, along);
  part.along = static_cast<float>(place > 0 ? std::min(place, 1.0) : 0);
  return part;
}

double strip_margin_px(const Picture& picture, const Affine& image_from_artboard) {
  std::vector<double> reach(picture.layers.size(), 0);
  for (std::size_t i = 0; i < reach.size(); ++i)
    for (const SoftEdge& edge : picture.layers[i].soft_edge)
      reach[i] = std::max({reach[i], length(edge.reach[0]), length(edge.reach[1])});
  double margin = 0;
  for (const PictureItem& item : picture.stack) {
    const auto* instance = std::get_if<PatchInstance>(&item);
    if (!instance || reach[instance->layer] == 0) continue;
    const Affine m = image_from_artboard * instance->artboard_from_layer;
    const double scale = std::sqrt(m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d);
    margin = std::max(margin, std::min(reach[instance->layer] * scale, kMostReachPx));
  }
  return margin;
}

}  // namespace sfumato::raster
