#pragma once

#include "color/matrix.hpp"

/// Matrices between colour spaces, computed at compile time from chromaticities.
namespace sfumato::color {

struct Chromaticity {
  double x, y;
};

/// Returns XYZ with Y = 1.
constexpr Triple xyz_of(const Chromaticity& c) {
  return {c.x / c.y, 1, (1 - c.x - c.y) / c.y};
}

inline constexpr Chromaticity kD50{0.3457, 0.3585};
inline constexpr Chromaticity kD65{0.3127, 0.3290};

/// The chromaticities of a space of red, green and blue.
struct Primaries {
  Chromaticity red, green, blue, white;
};

inline constexpr Primaries kSrgb{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, kD65};
inline constexpr Primaries kDisplayP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, kD65};
inline constexpr Primaries kA98{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, kD65};
inline constexpr Primaries kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, kD65};
inline constexpr Primaries kProphoto{
    {0.734699, 0.265301}, {0.159597, 0.840403}, {0.036598, 0.000105}, kD50};

/// Returns the matrix from linear light to XYZ, under the white point of the primaries.
constexpr Matrix xyz_from_linear(const Primaries& p) {
  const Matrix columns = transposed({{{xyz_of(p.red), xyz_of(p.green), xyz_of(p.blue)}}});
  return columns * diagonal(inverse(columns) * xyz_of(p.white));
}

inline constexpr Matrix kBradford{
    {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}}};

/// Returns Bradford's chromatic adaptation.
constexpr Matrix adaptation(const Chromaticity& from, const Chromaticity& to) {
  const Triple a = kBradford * xyz_of(from), b = kBradford * xyz_of(to);
  return inverse(kBradford) * (diagonal({b.x / a.x, b.y / a.y, b.z / a.z}) * kBradford);
}

inline constexpr Matrix kD65FromD50 = adaptation(kD50, kD65);
inline constexpr Matrix kXyzFromSrgb = xyz_from_linear(kSrgb);
inline constexpr Matrix kSrgbFromXyz = inverse(kXyzFromSrgb);
inline constexpr Matrix kXyzFromDisplayP3 = xyz_from_linear(kDisplayP3);
inline constexpr Matrix kXyzFromA98 = xyz_from_linear(kA98);
inline constexpr Matrix kXyzFromRec2020 = xyz_from_linear(kRec2020);
inline constexpr Matrix kXyzFromProphoto = kD65FromD50 * xyz_from_linear(kProphoto);

/// OKLab (Ottosson 2020) with the digits of CSS Color 4, section 10.
inline constexpr Matrix kLmsFromXyz{
    {{{0.8190224379967030, 0.3619062600528904, -0.1288737815209879},
      {0.0329836539323885, 0.9292868615863434, 0.0361446663506424},
      {0.0481771893596242, 0.2642395317527308, 0.6335478284694309}}}};
inline constexpr Matrix kOklabFromLms{
    {{{0.2104542683093140, 0.7936177747023054, -0.0040720430116193},
      {1.9779985324311684, -2.4285922420485799, 0.4505937096174110},
      {0.0259040424655478, 0.7827717124575296, -0.8086757549230774}}}};
inline constexpr Matrix kXyzFromLms = inverse(kLmsFromXyz);
inline constexpr Matrix kLmsFromOklab = inverse(kOklabFromLms);

}  // namespace sfumato::color
