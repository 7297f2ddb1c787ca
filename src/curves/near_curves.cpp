#include "curves/near_curves.hpp"

#include <algorithm>
#include <cmath>

#include "base/segment.hpp"

namespace sfumato::curves {
namespace {

/// The most boxes of the tree that one search visits.
constexpr int kSearchPatience = 256;

/// Segments that meet at a larger angle than 30 degrees part at once.
constexpr double kPartingCosine = 0.87;
constexpr double kPartingSine = 0.5;

double point_distance(Vec2 p, Vec2 a, Vec2 b) {
  return length(p - nearest_on_segment(p, a, b));
}

bool is_between(double x, double y) {
  return (x < 0) != (y < 0);
}

/// Returns the distance between the segments from a to b and from c to d.
double segment_distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (is_between(cross(b - a, c - a), cross(b - a, d - a)) &&
      is_between(cross(d - c, a - c), cross(d - c, b - c)))
    return 0;
  return std::min({point_distance(a, c, d), point_distance(b, c, d), point_distance(c, a, b),
                   point_distance(d, a, b)});
}

}  // namespace

double NearCurves::distance(std::uint32_t segment, Vec2 from, Vec2 to) const {
  Box box;
  box.extend(from);
  box.extend(to);
  double least = most_;
  const bool was_enough =
      tree_.visit([&](const Box& other) { return overlap(box, other); }, kSearchPatience,
                  [&](std::uint32_t other) {
                    if (other == segment || is_joined(segment, other)) return;
                    const double found = segment_distance(from, to, coarse_.vertex[other],
                                                          coarse_.vertex[other + 1]);
                    if (found < least && !coincide(segment, other) && !part_at_once(segment, other))
                      least = found;
                  });
  return was_enough ? least : 0;
}

/// Returns whether one segment continues the other, also where a closed curve ends.
bool NearCurves::is_joined(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t curve = coarse_.vertex_curve[a];
  if (curve != coarse_.vertex_curve[b]) return false;
  const auto [low, high] = std::minmax(a, b);
  if (high == low + 1) return true;
  const std::uint32_t first = coarse_.curve_begin[curve], last = coarse_.curve_begin[curve + 1] - 1;
  return low == first && high + 1 == last && coarse_.vertex[first] == coarse_.vertex[last];
}

bool NearCurves::coincide(std::uint32_t a, std::uint32_t b) const {
  const auto near = [&](Vec2 p, Vec2 q) { return length_squared(p - q) <= same_ * same_; };
  const Vec2 a0 = coarse_.vertex[a], a1 = coarse_.vertex[a + 1];
  const Vec2 b0 = coarse_.vertex[b], b1 = coarse_.vertex[b + 1];
  const bool same_ends = (near(a0, b0) && near(a1, b1)) || (near(a0, b1) && near(a1, b0));
  return same_ends && near(middle(a), middle(b));
}

/// Returns whether segments meet at an angle so large that they cannot meet again.
bool NearCurves::part_at_once(std::uint32_t a, std::uint32_t b) const {
  const Vec2 a0 = coarse_.vertex[a], a1 = coarse_.vertex[a + 1];
  const Vec2 b0 = coarse_.vertex[b], b1 = coarse_.vertex[b + 1];
  const Vec2 u = a1 - a0, v = b1 - b0;
  const double sizes = length(u) * length(v);
  const auto same = [&](Vec2 p, Vec2 q) { return length_squared(p - q) <= same_ * same_; };
  if (same(a0, b0) || same(a1, b1)) return dot(u, v) < kPartingCosine * sizes;
  if (same(a0, b1) || same(a1, b0)) return dot(u, v) > -kPartingCosine * sizes;
  return std::fabs(cross(u, v)) > kPartingSine * sizes && segment_distance(a0, a1, b0, b1) <= same_;
}

/// Returns the point of the curve at the middle of a segment's parameters.
Vec2 NearCurves::middle(std::uint32_t segment) const {
  const double from = coarse_.parameter[segment], to = coarse_.parameter[segment + 1];
  return point_at(piece_of(curves_[coarse_.vertex_curve[segment]], from),
                  0.5 * (from + to) - std::floor(from));
}

}  // namespace sfumato::curves
