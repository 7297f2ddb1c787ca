#include "color/gamut_map.hpp"

#include <algorithm>
#include <cmath>

#include "color/constants.hpp"
#include "color/space.hpp"
#include "color/transfer.hpp"

namespace sfumato::color {
namespace {

/// The just noticeable difference in OKLab.
constexpr double kJustNoticeable = 0.02;

/// The width at which the search ends, in OKLab.
constexpr double kNarrowest = 1e-4;

/// No colour of sRGB has more chroma in OKLCH: magenta has 0.3225.
constexpr double kLargestChroma = 0.323;

/// The excess that rounding may leave.
constexpr double kSlack = 1e-9;

bool is_within(const Triple& rgb) {
  return std::min({rgb.x, rgb.y, rgb.z}) >= -kSlack &&
         std::max({rgb.x, rgb.y, rgb.z}) <= 1 + kSlack;
}

Triple clipped(const Triple& rgb) {
  return {std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0), std::clamp(rgb.z, 0.0, 1.0)};
}

/// Returns the distance in OKLab between linear sRGB light and a colour.
double distance(const Triple& linear, const Triple& lab) {
  const Triple seen = oklab_from_xyz(kXyzFromSrgb * linear);
  const Triple miss{seen.x - lab.x, seen.y - lab.y, seen.z - lab.z};
  return std::sqrt(dot(miss, miss));
}

/// Returns linear sRGB light within 0 to 1. Clipping linear light has the same result as clipping
/// code values; scaling a and b needs no angle.
Triple mapped(const Triple& linear, const Triple& lab) {
  if (lab.x >= 1) return {1, 1, 1};
  if (lab.x <= 0) return {0, 0, 0};
  if (distance(clipped(linear), lab) < kJustNoticeable) return clipped(linear);
  const double chroma = std::sqrt(lab.y * lab.y + lab.z * lab.z);
  double low = 0, high = 1;
  bool low_is_within = true;
  while ((high - low) * chroma > kNarrowest) {
    const double share = (low + high) / 2;
    if (share * chroma > kLargestChroma + kJustNoticeable) {
      high = share;  // clipping would be visible
      continue;
    }
    const Triple scaled{lab.x, lab.y * share, lab.z * share};
    const Triple tried = linear_srgb_from_xyz(xyz_from_oklab(scaled));
    if (low_is_within && is_within(tried)) {
      low = share;
      continue;
    }
    const double error = distance(clipped(tried), scaled);
    if (error >= kJustNoticeable) {
      high = share;
      continue;
    }
    if (kJustNoticeable - error < kNarrowest) return clipped(tried);
    low_is_within = false;
    low = share;
  }
  const double share = (low + high) / 2;
  return clipped(linear_srgb_from_xyz(xyz_from_oklab({lab.x, lab.y * share, lab.z * share})));
}

Rgb rgb_of(const Triple& linear) {
  return {static_cast<float>(srgb_from_linear(linear.x)),
          static_cast<float>(srgb_from_linear(linear.y)),
          static_cast<float>(srgb_from_linear(linear.z))};
}

}  // namespace

SrgbColor map_to_srgb(const Triple& xyz) {
  const Triple linear = linear_srgb_from_xyz(xyz);
  if (is_within(linear)) return {rgb_of(clipped(linear)), false};
  const Triple lab = oklab_from_xyz(xyz);
  const Triple found = mapped(linear, lab);
  return {rgb_of(found), distance(found, lab) > kJustNoticeable / 10};
}

}  // namespace sfumato::color
