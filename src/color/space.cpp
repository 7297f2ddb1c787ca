#include "color/space.hpp"

#include "base/angle.hpp"
#include "base/root.hpp"
#include "color/constants.hpp"
#include "color/transfer.hpp"

namespace sfumato::color {
namespace {

double cubed(double x) {
  return x * x * x;
}

template <class Function>
Triple each(const Triple& v, Function function) {
  return {function(v.x), function(v.y), function(v.z)};
}

}  // namespace

Triple xyz_from(Space space, const Triple& c) {
  switch (space) {
    case Space::srgb:
      return kXyzFromSrgb * each(c, linear_from_srgb);
    case Space::srgb_linear:
      return kXyzFromSrgb * c;
    case Space::display_p3:
      return kXyzFromDisplayP3 * each(c, linear_from_srgb);
    case Space::display_p3_linear:
      return kXyzFromDisplayP3 * c;
    case Space::a98_rgb:
      return kXyzFromA98 * each(c, linear_from_a98);
    case Space::prophoto_rgb:
      return kXyzFromProphoto * each(c, linear_from_prophoto);
    case Space::rec2020:
      return kXyzFromRec2020 * each(c, linear_from_rec2020);
    case Space::xyz_d50:
      return kD65FromD50 * c;
    case Space::xyz_d65:
      break;
  }
  return c;
}

Triple xyz_from_lab(const Triple& lab) {
  constexpr double kKappa = 24389.0 / 27, kEpsilon = 216.0 / 24389;
  constexpr Triple kWhite = xyz_of(kD50);
  const double fy = (lab.x + 16) / 116;
  const auto share = [](double f) {
    return cubed(f) > kEpsilon ? cubed(f) : (116 * f - 16) / kKappa;
  };
  return kD65FromD50 * Triple{kWhite.x * share(fy + lab.y / 500), kWhite.y * share(fy),
                              kWhite.z * share(fy - lab.z / 200)};
}

Triple xyz_from_oklab(const Triple& lab) {
  return kXyzFromLms * each(kLmsFromOklab * lab, cubed);
}

Triple oklab_from_xyz(const Triple& xyz) {
  return kOklabFromLms * each(kLmsFromXyz * xyz, cube_root);
}

Triple lab_from_lch(double lightness, double chroma, double hue_degrees) {
  const SinCos hue = sin_cos_degrees(hue_degrees);
  return {lightness, chroma * hue.cos, chroma * hue.sin};
}

Triple linear_srgb_from_xyz(const Triple& xyz) {
  return kSrgbFromXyz * xyz;
}

}  // namespace sfumato::color
