#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sfumato/base/vec2.hpp"

namespace sfumato::curves {

/// A cubic Bézier piece by its four control points.
using Cubic = std::array<Vec2, 4>;

/// Returns piece i of a chain of 3 n + 1 control points. Precondition: i < n.
inline Cubic piece(std::span<const Vec2> control_points, std::size_t i) {
  return {control_points[3 * i], control_points[3 * i + 1], control_points[3 * i + 2],
          control_points[3 * i + 3]};
}

/// Returns the point at t in [0, 1], by de Casteljau: exact at both ends.
Vec2 point_at(const Cubic& cubic, double t);

Vec2 derivative_at(const Cubic& cubic, double t);

/// Returns the part of the cubic from t0 to t1.
Cubic subcurve(const Cubic& cubic, double t0, double t1);

/// The largest deviation over t of a cubic from its chord traversed at constant speed, C(t) −
/// lerp(P0, P3, t): across the chord and along it.
struct ChordDeviation {
  double across = 0;
  double along = 0;
};

ChordDeviation chord_deviation(const Cubic& cubic);

/// Returns the mean over t of the component of C(t) − lerp(P0, P3, t) across the chord: the mean
/// distance of the arc from its chord.
Vec2 mean_deviation(const Cubic& cubic);

/// Returns a parameter of the point nearest to `point`, by Newton's method from a close start.
double nearest_parameter(const Cubic& cubic, Vec2 point, double close_by);

/// Returns the length of the part from t0 to t1 (Gauss–Legendre on halves until the error is below
/// 1e-9 of it).
double arc_length(const Cubic& cubic, double t0, double t1);

/// Returns the parameter in [0, 1] at `length` from the start, by Newton's method on arc_length,
/// with bisection where that does not converge.
double parameter_at_length(const Cubic& cubic, double length);

}  // namespace sfumato::curves
