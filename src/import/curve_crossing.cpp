#include "import/curve_crossing.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace sfumato::svg_import {
namespace {

using curves::Cubic;

/// The range of the projections of a curve's control points on an axis.
struct Interval {
  double low;
  double high;
};

Interval along(Vec2 axis, const Cubic& curve) {
  const auto [low, high] = std::minmax(
      {dot(axis, curve[0]), dot(axis, curve[1]), dot(axis, curve[2]), dot(axis, curve[3])});
  return {low, high};
}

bool is_apart(Vec2 axis, const Cubic& a, const Cubic& b) {
  const Interval of_a = along(axis, a), of_b = along(axis, b);
  return of_a.high < of_b.low || of_b.high < of_a.low;
}

/// Returns whether a line separates the control polygons, and hence the curves.
bool are_apart(const Cubic& a, const Cubic& b) {
  return is_apart({1, 0}, a, b) || is_apart({0, 1}, a, b) || is_apart(left_of(a[3] - a[0]), a, b) ||
         is_apart(left_of(b[3] - b[0]), a, b);
}

bool chords_cross(const Cubic& a, const Cubic& b) {
  const Vec2 along_a = a[3] - a[0], along_b = b[3] - b[0];
  const double from_b = cross(along_a, b[0] - a[0]), to_b = cross(along_a, b[3] - a[0]);
  const double from_a = cross(along_b, a[0] - b[0]), to_a = cross(along_b, a[3] - b[0]);
  const bool parts_b = (from_b < 0 && to_b > 0) || (from_b > 0 && to_b < 0);
  const bool parts_a = (from_a < 0 && to_a > 0) || (from_a > 0 && to_a < 0);
  return parts_a && parts_b;
}

double deviation(const Cubic& curve) {
  const curves::ChordDeviation found = curves::chord_deviation(curve);
  return std::max(found.across, found.along);
}

double extent(const Cubic& curve) {
  double largest = 0;
  for (const Vec2 p : curve) {
    largest = std::max({largest, std::abs(p.x - curve[0].x), std::abs(p.y - curve[0].y)});
  }
  return largest;
}

std::array<Cubic, 2> halves(const Cubic& c) {
  const Vec2 ab = lerp(c[0], c[1], 0.5), bc = lerp(c[1], c[2], 0.5), cd = lerp(c[2], c[3], 0.5);
  const Vec2 abc = lerp(ab, bc, 0.5), bcd = lerp(bc, cd, 0.5), middle = lerp(abc, bcd, 0.5);
  return {Cubic{c[0], ab, abc, middle}, Cubic{middle, bcd, cd, c[3]}};
}

/// Returns the mean direction of points as seen from `from`; points at `from` do not count.
Vec2 mean_direction(Vec2 from, std::span<const Vec2> points) {
  Vec2 sum;
  for (const Vec2 p : points) {
    const double size = length(p - from);
    if (size > 0) sum = sum + (p - from) / size;
  }
  const double size = length(sum);
  return size > 0 ? sum / size : Vec2{};
}

/// Returns whether a line through the joint separates all other control points, so that the curves
/// meet nowhere else.
bool part_at_joint(const Cubic& curve, const Cubic& next) {
  const Vec2 joint = next[0];
  const std::span before(curve.data(), 3), after(next.data() + 1, 3);
  const Vec2 normal = mean_direction(joint, after) - mean_direction(joint, before);
  const auto is_behind = [&](Vec2 p) { return p == joint || dot(normal, p - joint) < 0; };
  const auto is_ahead = [&](Vec2 p) { return p == joint || dot(normal, p - joint) > 0; };
  return std::ranges::all_of(before, is_behind) && std::ranges::all_of(after, is_ahead);
}

}  // namespace

bool CurveCrossing::of(const Cubic& a, const Cubic& b) {
  halvings_left_ = kMostHalvings;
  return cross(a, b);
}

bool CurveCrossing::beyond_joint(const Cubic& curve, const Cubic& next) {
  halvings_left_ = kMostHalvings;
  return cross_beyond_joint(curve, next);
}

bool CurveCrossing::cross(const Cubic& a, const Cubic& b) {
  if (are_apart(a, b)) return false;
  place_ = lerp(a[0], a[3], 0.5);
  if (--halvings_left_ <= 0) return true;
  const double of_a = deviation(a), of_b = deviation(b);
  if (of_a <= flat_ && of_b <= flat_) return chords_cross(a, b);
  if (of_a < of_b) {
    const auto [first, second] = halves(b);
    return cross(a, first) || cross(a, second);
  }
  const auto [first, second] = halves(a);
  return cross(first, b) || cross(second, b);
}

bool CurveCrossing::cross_beyond_joint(const Cubic& curve, const Cubic& next) {
  if (part_at_joint(curve, next)) return false;
  if (extent(curve) + extent(next) <= joint_) return false;
  place_ = next[0];
  if (--halvings_left_ <= 0) return true;
  const auto [far, near] = halves(curve);
  const auto [here, there] = halves(next);
  return cross_beyond_joint(near, here) || cross(far, here) || cross(near, there) ||
         cross(far, there);
}

}  // namespace sfumato::svg_import
