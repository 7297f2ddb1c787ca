#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::mesh {

/// A lattice point: whole steps from the lattice's origin, 0 to 2^kLatticeBits on both axes.
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }
};

/// Differences of coordinates stay within 29 bits: orientations fit into 64 bits, in-circle
/// determinants into 128.
inline constexpr int kLatticeBits = 29;

/// The least weld, in steps. Below four, duplicates of curves cannot be distinguished from rounding
/// noise.
inline constexpr double kLeastWeldSteps = 16;

/// Returns twice the signed area of (a, b, c). Exact.
constexpr std::int64_t orient2d(Point a, Point b, Point c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{b.y - a.y} * (c.x - a.x);
}

/// Returns the squared distance. Exact.
constexpr std::int64_t distance_squared(Point a, Point b) {
  const std::int64_t x = a.x - b.x;
  const std::int64_t y = a.y - b.y;
  return x * x + y * y;
}

/// Returns (b - a) · (c - a). Exact.
constexpr std::int64_t dot_from(Point a, Point b, Point c) {
  return std::int64_t{b.x - a.x} * (c.x - a.x) + std::int64_t{b.y - a.y} * (c.y - a.y);
}

/// Two coordinates in one vector register, where the machine has such registers.
typedef std::int32_t IntegerPair __attribute__((vector_size(8)));
typedef double Pair __attribute__((vector_size(16)));

/// Returns a - b. Exact.
inline Pair difference(const Point& a, const Point& b) {
  return __builtin_convertvector(std::bit_cast<IntegerPair>(a) - std::bit_cast<IntegerPair>(b),
                                 Pair);
}

inline double squared(Pair a) {
  a *= a;
  return a[0] + a[1];
}

inline double cross(Pair a, Pair b) {
  a *= __builtin_shufflevector(b, b, 1, 0);
  return a[0] - a[1];
}

/// Does in_circle() by 128-bit integers.
bool in_circle_exact(Point a, Point b, Point c, Point d);

/// Returns whether d lies strictly inside the circle through a, b, c (positively oriented). Exact.
inline bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Pair ad = difference(a, d), bd = difference(b, d), cd = difference(c, d);
  const double a2 = squared(ad), b2 = squared(bd), c2 = squared(cd);
  const double determinant = a2 * cross(bd, cd) + b2 * cross(cd, ad) + c2 * cross(ad, bd);
  // Shewchuk's static bound is (10 + 96 e) e times the permanent, e = 2^-53: 1.11e-15; here the
  // differences are also exact. |bx cy| + |cx by| <= (b2 + c2) / 2 and so on: the permanent is at
  // most a third of the squared sum.
  const double sum = a2 + b2 + c2;
  const double error = sum * sum * 4e-16;
  if (std::fabs(determinant) > error) [[likely]]
    return determinant > 0;
  return in_circle_exact(a, b, c, d);
}

/// Returns the position of vertex v along the chord from a to b: its projection as a fraction, 0 to
/// 1.
inline double fraction_along(Point a, Point b, Point v) {
  const double s =
      static_cast<double>(dot_from(a, b, v)) / static_cast<double>(distance_squared(a, b));
  return std::clamp(s, 0.0, 1.0);
}

/// The lattice of one mesh and the domain that it triangulates: [0, width] × [0, height] steps.
struct Lattice {
  double step = 1;          ///< user units, a power of two
  double inverse_step = 1;  ///< exact
  Vec2 origin;              ///< in steps from the user origin, whole
  std::int32_t width = 0;
  std::int32_t height = 0;
  Point frame_min;  ///< smallest lattice rectangle around MeshOptions::frame
  Point frame_max;
  std::int64_t weld_squared = 0;  ///< steps²

  /// Returns the nearest lattice point. Precondition: p lies in the domain.
  Point nearest(Vec2 p) const {
    return {static_cast<std::int32_t>(p.x * inverse_step - origin.x + 0.5),
            static_cast<std::int32_t>(p.y * inverse_step - origin.y + 0.5)};
  }

  /// Returns user units. Exact.
  Vec2 position(Point p) const { return {(origin.x + p.x) * step, (origin.y + p.y) * step}; }

  /// Returns the lattice point nearest to (x, y) steps, inside the domain.
  Point rounded(double x, double y) const {
    return {static_cast<std::int32_t>(std::clamp(x, 0.0, double(width)) + 0.5),
            static_cast<std::int32_t>(std::clamp(y, 0.0, double(height)) + 0.5)};
  }
};

/// Chooses a step of about unit_size / 2^12 (a power of two), coarser where the padded bounding box
/// of curves and frame would exceed 2^kLatticeBits steps. The weld is at most 1/32 of the frame's
/// shorter side, but never below kLeastWeldSteps. Errors: bad_input (a coordinate that is not
/// finite or beyond limits::kCoordinate, an empty frame, a unit size or weld that is not above 0).
Result<Lattice> choose_lattice(const curves::FlatCurves& flat, const MeshOptions& options);

}  // namespace sfumato::mesh
