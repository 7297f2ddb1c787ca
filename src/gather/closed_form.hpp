#pragma once

#include "base/lanes.hpp"

/// The closed form of DESIGN 2.2 in lanes, single precision.
namespace sfumato::gather::inline SFUMATO_ISA {

/// Weights of the two ends of a visible part: W = right + left, ∫ w z dθ = right z₁ + left z₂.
template <class F>
struct EndWeights {
  F right;
  F left;
};

/// h₁ = (D - s c) / (2 s³) as a function of c = cos D in [0, 1]: relative error 7e-7.
/// h₂ = (s - D c) / s³ needs no polynomial of its own: it is 1 - 2 c h₁, for every D.
template <class F>
SFUMATO_INLINE F h1_of_cosine(const F& c) {
  const F c2 = c * c;
  const F even =
      (((F(0.0550776520f) * c2 + F(0.745227222f)) * c2 + F(1.34334345f)) * c2 + F(1.17598814f)) *
          c2 +
      F(0.785397680f);
  const F odd =
      ((F(-0.299742184f) * c2 + F(-1.16153776f)) * c2 + F(-1.31049818f)) * c2 + F(-0.999922482f);
  return odd * c + even;
}

/// The visible part from q1 (right end) to q2 (left end), relative to the point: DESIGN 2.2 with
/// G₁ = s h₁ and G₂ = s h₂, so that w₁ = u₁u₂ s (1/2 + h₁ (u₁/u₂ - c)) and likewise w₂. All is
/// made from u₁u₂ = 1/√(r₁² r₂²): no angle, no normal, no distance.
///
/// cross_q   q1 × q2 in its most precise form. It is used where D <= 90°; above, q1 × q2 itself is
///           better (the point is near the segment), and s is kept off 0: the point may lie on it.
///           Below 90° s may be 0: an edge-on part near a tip must not get a weight from a clamp.
/// lanes     those that matter; others may hold anything.
template <class F>
SFUMATO_INLINE EndWeights<F> end_weights(const F& q1x, const F& q1y, const F& q2x, const F& q2y,
                                         const F& cross_q, const typename F::Mask& lanes) {
  const F tiny(1e-16f);
  const F r1_squared = max(q1x * q1x + q1y * q1y, tiny);
  const F r2_squared = max(q2x * q2x + q2y * q2y, tiny);
  const F u1u2 = reciprocal_sqrt(r1_squared * r2_squared);
  F s = max(cross_q * u1u2, F(0));
  F c = (q1x * q2x + q1y * q2y) * u1u2;
  const F c_size = min(abs(c), F(1));
  F h1 = h1_of_cosine(c_size);
  const auto obtuse = (c < F(0)) & lanes;
  if (__builtin_expect(any(obtuse), 0)) {
    const F s_direct = max((q1x * q2y - q1y * q2x) * u1u2, F(1e-6f));
    const F h1_obtuse = F(1.57079633f) * reciprocal(s_direct * s_direct * s_direct) - h1;
    h1 = select(obtuse, h1_obtuse, h1);
    s = select(obtuse, s_direct, s);
    c = max(c, F(-1));
  }
  const F common = u1u2 * s;
  return {common * (F(0.5f) + h1 * (u1u2 * r2_squared - c)),
          common * (F(0.5f) + h1 * (u1u2 * r1_squared - c))};
}

}  // namespace sfumato::gather::inline SFUMATO_ISA
