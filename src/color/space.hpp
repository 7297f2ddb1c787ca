#pragma once

#include <cstdint>

#include "color/matrix.hpp"

namespace sfumato::color {

/// The spaces of CSS's color(). In a space with primaries and a white point, 0 to 1 are the colours
/// of the space.
enum class Space : std::uint8_t {
  srgb,
  srgb_linear,
  display_p3,
  display_p3_linear,
  a98_rgb,
  prophoto_rgb,
  rec2020,
  xyz_d50,
  xyz_d65
};

/// Converts a colour in `space` to CIE XYZ under D65, with Y = 1 for white. Values outside the
/// space are extrapolated: the transfer functions are odd.
///
/// All functions of this header compute in double precision, only by correctly rounded operations,
/// so that every machine gives the same bits.
Triple xyz_from(Space space, const Triple& components);

/// Converts CIE Lab under D50 to XYZ (D65): L from 0 to 100.
Triple xyz_from_lab(const Triple& lab);

/// Converts OKLab to XYZ (D65): L from 0 to 1.
Triple xyz_from_oklab(const Triple& lab);
Triple oklab_from_xyz(const Triple& xyz);

/// Converts LCH to Lab, or OKLCH to OKLab.
Triple lab_from_lch(double lightness, double chroma, double hue_degrees);

/// Returns linear light of sRGB's primaries for XYZ (D65).
Triple linear_srgb_from_xyz(const Triple& xyz);

}  // namespace sfumato::color
