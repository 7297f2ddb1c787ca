#pragma once

#include "base/lanes.hpp"
#include "curves/front_share.hpp"

/// β of eq. 8 in lanes, single precision, where the radius is constant on a visible part and where
/// it varies (docs/mathematics.md, blur radii).
namespace sfumato::gather::inline SFUMATO_ISA {

/// Computes curves::front_share in lanes: β with one radius. The prose under eq. 8 says that it
/// falls "to 0" at distance R; the formula, and the limit R → 0, say 1. R == 0 is handled by
/// select, not by dividing: 0/0 would spoil whole lanes. Precondition: distance and radius >= 0.
template <class F>
SFUMATO_INLINE F front_share(const F& distance, const F& radius) {
  const F x = F(0.5f) + F(0.5f) * distance / radius;
  return select(radius > distance, curves::smoothstep(x), F(1));
}

/// A visible part on which the radius grows from `near_radius` to `far_radius`, both at least the
/// distance of the part's line.
template <class F>
struct GrowingBlur {
  F near_length;  ///< from the point to the part's end with the smaller radius
  F far_length;
  F cosine;  ///< of the angle between the two
  F near_radius;
  F far_radius;
  F distance;  ///< r⊥
};

/// Means over the part, with the weights of the gather: of 1 - β, and of (1 - β) T, where T is the
/// fraction of the way from the near end to the far end.
template <class F>
struct BackMeans {
  F share;
  F moment;
};

inline constexpr int kBlurNodes = 6;
/// 2 x² - 1 of Gauss's six nodes x in [0, 1], and their weights times x.
inline constexpr float kBlurNode[kBlurNodes] = {-0.997719817f, -0.94261046f, -0.710149628f,
                                                -0.232911256f, 0.379808313f, 0.867219212f};
inline constexpr float kBlurNodeWeight[kBlurNodes] = {0.0057848131f, 0.0611113173f, 0.178130346f,
                                                      0.289783588f,  0.299650256f,  0.165539679f};

/// Integrates by Gauss's rule in the angle, by τ with tan(angle off the middle / 2) = τ tan(D / 4):
/// all of it is rational then. With k = tan²(D / 4), A = r_far (1 - τ)(1 + kτ), B = r_near (1 +
/// τ)(1 - kτ):
///
///     w dθ ∝ (A + B)² / (1 + kτ²)³ dτ,   T = B / (A + B),
///     r⊥/R = r⊥ (A + B) / (R_near A + R_far B)
///
/// Nodes are densest at the near end (τ = 2x² - 1), where 1 - β = (1 - y)² (2 + y) / 4, y = r⊥/R,
/// changes fastest. With six nodes the error of the mean is at most 0.001, for any growth of the
/// radius.
template <class F>
SFUMATO_INLINE BackMeans<F> back_means(const GrowingBlur<F>& part) {
  const F cosine = min(max(part.cosine, F(-1)), F(1));
  const F edge = F(2) + sqrt(F(2) + F(2) * cosine);
  const F k = (F(2) - F(2) * cosine) * reciprocal(edge * edge);
  F all(0), back(0), moment(0);
#pragma GCC unroll 8
  for (int i = 0; i < kBlurNodes; ++i) {
    const F tau(kBlurNode[i]);
    const F k_tau = k * tau;
    const F a = part.far_length * ((F(1) - tau) * (F(1) + k_tau));
    const F b = part.near_length * ((F(1) + tau) * (F(1) - k_tau));
    const F both = a + b;
    const F stretch = F(1) + k_tau * tau;
    const F per_length = F(kBlurNodeWeight[i]) * both * reciprocal(stretch * stretch * stretch);
    const F y = min(part.distance * both / (part.near_radius * a + part.far_radius * b), F(1));
    const F behind = F(0.25f) * ((F(1) - y) * (F(1) - y) * (F(2) + y));
    all = all + per_length * both;
    back = back + per_length * both * behind;
    moment = moment + per_length * b * behind;
  }
  return {back / all, moment / all};
}

}  // namespace sfumato::gather::inline SFUMATO_ISA
