#include "gather/reference_weights.hpp"

#include <cmath>

namespace sfumato::gather {
namespace {

/// Returns (D - sin D cos D) / (2 sin³ D): the closed form, and its series where that would cancel.
double h1(double angle) {
  const double s = std::sin(angle);
  if (angle > 0.25) return (angle - s * std::cos(angle)) / (2 * s * s * s);
  const double x2 = 4 * angle * angle;
  const double series =
      1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * (1 - x2 / 110 * (1 - x2 / 156))));
  const double ratio = angle / s;
  return series * ratio * ratio * ratio / 3;
}

}  // namespace

ReferenceWeights reference_weights(Vec2 q1, Vec2 q2) {
  const double r1 = length(q1), r2 = length(q2);
  if (!(cross(q1, q2) > 0)) return {};
  const double u1 = 1 / r1, u2 = 1 / r2;
  const double s = cross(q1, q2) * u1 * u2, c = dot(q1, q2) * u1 * u2;
  const double h = h1(std::atan2(s, c));
  const double g1 = s * h, g2 = s * (1 - 2 * c * h);
  return {u1 * (u1 * g1 + u2 * g2 / 2), u2 * (u2 * g1 + u1 * g2 / 2)};
}

}  // namespace sfumato::gather
