#pragma once

#include "base/lanes.hpp"

/// The closed form of docs/mathematics.md in lanes, single precision.
namespace sfumato::gather::inline SFUMATO_ISA {

/// ∫ w dθ over a visible part, with k = 1, and its asymmetry `lean`: the weights w₁ of the right
/// end and w₂ of the left end are (W ∓ lean) / 2.
template <class F>
struct PartWeight {
  F weight;  ///< W = w₁ + w₂
  F lean;    ///< w₂ - w₁
};

/// Returns h₁ = (D - s c) / (2 s³) as a function of c = cos D in [0, 1]: relative error 4e-6. h₂ =
/// (s - D c) / s³ needs no separate polynomial: it is 1 - 2 c h₁, for every D.
template <class F>
SFUMATO_INLINE F h1_of_cosine(const F& c) {
  const F c2 = c * c;
  const F even =
      ((F(0.375298610f) * c2 + F(1.18969841f)) * c2 + F(1.17074506f)) * c2 + F(0.785395477f);
  const F odd =
      ((F(-0.0760769620f) * c2 + F(-0.841909030f)) * c2 + F(-1.27015964f)) * c2 + F(-0.999659733f);
  return odd * c + even;
}

/// Computes the weight of the visible part from q1 (right end) to q2 (left end), relative to the
/// point. With G₁ = s h₁ and G₂ = s (1 - 2 c h₁), it reduces to
///
///     W = u₁u₂ s (1 + h₁ u₁u₂ |q2 - q1|²)      w₂ - w₁ = u₁u₂ s h₁ u₁u₂ (r₁² - r₂²)
///
/// with u₁u₂ = 1/√(r₁² r₂²): no angle, no normal, no distance, and all terms of W positive.
///
/// - `cross_q`: q1 × q2 in its most precise form, used where D <= 90°. Above 90° the point is near
///   the segment, q1 × q2 itself is better, and s is kept off 0, as the point may lie on the
///   segment. Below 90° s may be 0: a part seen edge-on near a tip must not get a weight from a
///   clamp.
/// - `length_squared`: |q2 - q1|²
/// - `lanes`: the lanes to compute; the others get 0.
template <class F>
SFUMATO_INLINE PartWeight<F> part_weight(const F& q1x, const F& q1y, const F& q2x, const F& q2y,
                                         const F& cross_q, const F& length_squared,
                                         const typename F::Mask& lanes) {
  const F r1_squared = q1x * q1x + q1y * q1y;
  const F r2_squared = q2x * q2x + q2y * q2y;
  // A point may lie on an end; the bound keeps all products finite.
  const F u1u2 = min(reciprocal_sqrt(r1_squared * r2_squared), F(1e7f));
  F s = max(cross_q * u1u2, F(0));
  const F c = (q1x * q2x + q1y * q2y) * u1u2;
  F h1 = h1_of_cosine(c);
  const auto obtuse = (c < F(0)) & lanes;
  if (__builtin_expect(any(obtuse), 0)) {
    // h₁(π - D) = π / (2 s³) - h₁(D).
    const F s_direct = max((q1x * q2y - q1y * q2x) * u1u2, F(1e-4f));
    const F rest = h1_of_cosine(min(abs(c), F(1)));
    const F h1_direct = F(1.57079633f) * reciprocal(s_direct * s_direct * s_direct) - rest;
    s = select(obtuse, s_direct, s);
    h1 = select(obtuse, h1_direct, h1);
  }
  const F common = zero_unless(lanes, u1u2 * s);
  const F steep = h1 * u1u2;
  return {common + common * (steep * length_squared), common * (steep * (r1_squared - r2_squared))};
}

}  // namespace sfumato::gather::inline SFUMATO_ISA
