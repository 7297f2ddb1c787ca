#pragma once

#include <cstddef>
#include <span>

#include "curves/front_share.hpp"
#include "gather/rows/rows.hpp"
#include "trace/fit/sparse.hpp"

namespace sfumato::tracing {

/// dβ/dR of eq. 8, for a point at a distance from the line of an edge with this radius.
inline double share_slope(double distance, double radius) {
  if (!(radius > distance)) return 0;
  const double x = 0.5 + 0.5 * distance / radius;
  return curves::smoothstep_slope(x) * (-0.5 * distance / (radius * radius));
}

/// Returns the value of a side at a place on its edge, from the values of all stops. Precondition:
/// it has stops.
inline FourFloats value_of(const gather::RowSide& side, double moment,
                           std::span<const FourFloats> x) {
  const double next = side.from + moment * (double{side.to} - side.from);
  const FourFloats& from = x[side.column];
  if (!(next > 0)) return from;
  const FourFloats& to = x[side.column + 1];
  FourFloats value;
  for (std::size_t c = 0; c < 4; ++c) {
    value[c] = static_cast<float>(from[c] + next * (to[c] - from[c]));
  }
  return value;
}

}  // namespace sfumato::tracing
