#pragma once

#include "base/lanes.hpp"
#include "sfumato/base/color_space.hpp"

/// The conversions of base/color_space.hpp to code values, for pixels. Compiled for every
/// instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// Returns min(max(x, 0), 1); 0 where x is NaN.
template <int W>
SFUMATO_INLINE Lanes<W> clamped_unit(const Lanes<W>& x) {
  return min(max(x, Lanes<W>(0)), Lanes<W>(1));
}

/// Applies sRGB's transfer function to linear light in [0, 1], within 1e-6.
///
/// x^(1/2.4) is sqrt(x) q^(-1/3) with q = x^(1/4). The inverse cube root is a polynomial fitted to
/// q from 0.0031308^(1/4) to 1 (relative error 4e-4), and one Newton step, which doubles its
/// square.
template <int W>
SFUMATO_INLINE Lanes<W> code_from_linear_lanes(const Lanes<W>& linear) {
  using F = Lanes<W>;
  const F x = max(linear, F(0.0031308f));
  const F root = sqrt(x);
  const F q = sqrt(root);
  F y = F(2.5503845f) +
        q * (F(-6.3997044f) +
             q * (F(13.916265f) + q * (F(-17.62457f) + q * (F(11.712713f) + q * F(-3.1554925f)))));
  y = y * (F(4.0f / 3) - q * F(1.0f / 3) * (y * y * y));
  return select(linear > F(0.0031308f), F(1.055f) * (root * y) - F(0.055f), F(12.92f) * linear);
}

template <int W>
struct Rgb3 {
  Lanes<W> r, g, b;
};

template <int W>
SFUMATO_INLINE Lanes<W> cube(const Lanes<W>& x) {
  return x * x * x;
}

template <int W>
SFUMATO_INLINE Rgb3<W> linear_from_oklab_lanes(const Rgb3<W>& lab) {
  using F = Lanes<W>;
  const F l = cube(lab.r + F(0.3963377774f) * lab.g + F(0.2158037573f) * lab.b);
  const F m = cube(lab.r - F(0.1055613458f) * lab.g - F(0.0638541728f) * lab.b);
  const F s = cube(lab.r - F(0.0894841775f) * lab.g - F(1.2914855480f) * lab.b);
  return {F(4.0767416621f) * l - F(3.3077115913f) * m + F(0.2309699292f) * s,
          F(-1.2684380046f) * l + F(2.6097574011f) * m - F(0.3413193965f) * s,
          F(-0.0041960863f) * l - F(0.7034186147f) * m + F(1.7076147010f) * s};
}

/// Converts a colour of `space` to code values in [0, 1]; within 1e-6 of to_srgb, 2e-5 from OKLab.
template <int W>
SFUMATO_INLINE Rgb3<W> clamped_srgb(InterpolationSpace space, Rgb3<W> color) {
  if (space == InterpolationSpace::oklab) color = linear_from_oklab_lanes(color);
  color = {clamped_unit(color.r), clamped_unit(color.g), clamped_unit(color.b)};
  if (space == InterpolationSpace::srgb) return color;
  return {code_from_linear_lanes(color.r), code_from_linear_lanes(color.g),
          code_from_linear_lanes(color.b)};
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
