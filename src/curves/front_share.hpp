#pragma once

#include <concepts>

#include "base/inline.hpp"

/// β of eq. 8: the share of the side in front of a curve in the picture. This is its only
/// definition. Tests compare all other forms of β with it: the strips of soft edges, the closed
/// forms of kernels/blur_kernel.hpp, the shaders, and the test reference gather/reference.cpp.
namespace sfumato::curves {

/// Returns the polynomial of β: from 0 at 0 to 1 at 1, with slope 0 at both.
template <class F>
SFUMATO_INLINE constexpr F smoothstep(const F& x) {
  return x * x * (F(3) - F(2) * x);
}

constexpr double smoothstep_slope(double x) {
  return 6 * x * (1 - x);
}

/// Returns β at a distance from a curve with a blur radius, both 0 or above: 1/2 on the curve, 1
/// from the radius on, and 1 where the radius is 0.
template <std::floating_point F>
constexpr F front_share(F distance, F radius) {
  if (!(radius > distance)) return 1;
  return smoothstep(F(0.5) + F(0.5) * distance / radius);
}

/// The derivative of β with respect to the distance, on the curve itself, times the radius.
inline constexpr double kFrontShareSlope = 0.5 * smoothstep_slope(0.5);

}  // namespace sfumato::curves
