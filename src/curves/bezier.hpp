#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sfumato/base/vec2.hpp"

namespace sfumato::curves {

/// A cubic Bézier piece by its four control points.
using Cubic = std::array<Vec2, 4>;

/// Piece i of a chain of 3 n + 1 control points. Precondition: i < n.
inline Cubic piece(std::span<const Vec2> control_points, std::size_t i) {
  return {control_points[3 * i], control_points[3 * i + 1], control_points[3 * i + 2],
          control_points[3 * i + 3]};
}

/// The point at t in [0, 1], by de Casteljau: exact at both ends.
Vec2 point_at(const Cubic& cubic, double t);

Vec2 derivative_at(const Cubic& cubic, double t);

/// The stretch of the cubic from t0 to t1.
Cubic subcurve(const Cubic& cubic, double t0, double t1);

/// The largest deviation over t of a cubic from its chord traversed at constant speed, C(t) −
/// lerp(P0, P3, t): across the chord and along it.
struct ChordDeviation {
  double across = 0;
  double along = 0;
};

ChordDeviation chord_deviation(const Cubic& cubic);

/// The mean over t of the component of C(t) − lerp(P0, P3, t) across the chord: the mean distance
/// of the arc from its chord.
Vec2 mean_deviation(const Cubic& cubic);

/// A parameter of the point nearest to `point`, by Newton's method from one that is close.
double nearest_parameter(const Cubic& cubic, Vec2 point, double close_by);

/// Length of the stretch from t0 to t1 (Gauss–Legendre on halves until it settles to 1e-9 of it).
double arc_length(const Cubic& cubic, double t0, double t1);

/// The parameter in [0, 1] at `length` from the start, by Newton's method on arc_length, with
/// halving where that does not settle.
double parameter_at_length(const Cubic& cubic, double length);

}  // namespace sfumato::curves
