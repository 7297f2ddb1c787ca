#pragma once

#include <cstdint>

#include "sfumato/base/color.hpp"

namespace sfumato {

/// The spaces for interpolating colours.
enum class InterpolationSpace : std::uint8_t {
  srgb,    ///< sRGB code values, as most programs do
  linear,  ///< linear light
  oklab    ///< OKLab (Ottosson 2020)
};

/// Returns the linear light of an sRGB code value: the inverse of sRGB's transfer function (IEC
/// 61966-2-1). Both are from 0 to 1. The same formulas continue beyond that range.
double linear_from_code(double code);
/// Returns the sRGB code value of linear light: the inverse of linear_from_code().
double code_from_linear(double linear);

/// Converts sRGB code values to the coordinates of `space`. The fields r, g and b of the result
/// hold code values, linear light, or OKLab's L, a and b. White is (1, 1, 1), in OKLab (1, 0, 0).
///
/// Computes in double precision, only by correctly rounded operations, so that every machine gives
/// the same bits. Conversion there and back is within 2e-7 for linear light and within 3e-6 for
/// OKLab, whose coordinates are rounded to single precision in between.
Rgb from_srgb(InterpolationSpace space, const Rgb& code);
/// Converts the coordinates of `space` to sRGB code values: the inverse of from_srgb(). The result
/// is not clamped to 0 to 1.
Rgb to_srgb(InterpolationSpace space, const Rgb& color);

}  // namespace sfumato
