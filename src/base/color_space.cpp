#include "sfumato/base/color_space.hpp"

#include <cmath>

#include "base/root.hpp"

namespace sfumato {
namespace {

double cube(double x) {
  return x * x * x;
}

struct Triple {
  double x, y, z;
};

Triple linear_from_srgb(const Rgb& code) {
  return {linear_from_code(code.r), linear_from_code(code.g), linear_from_code(code.b)};
}

Rgb srgb_from_linear(const Triple& linear) {
  return {static_cast<float>(code_from_linear(linear.x)),
          static_cast<float>(code_from_linear(linear.y)),
          static_cast<float>(code_from_linear(linear.z))};
}

Rgb rgb(const Triple& t) {
  return {static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(t.z)};
}

Triple oklab_from_linear(const Triple& c) {
  const double l = cube_root(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  const double m = cube_root(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  const double s = cube_root(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Triple linear_from_oklab(const Rgb& lab) {
  const double lightness = lab.r, a = lab.g, b = lab.b;
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

}  // namespace

double linear_from_code(double code) {
  if (!(code > 0.04045)) return code / 12.92;
  const double base = (code + 0.055) / 1.055;
  const double fifth = root<5>(base);
  return base * base * (fifth * fifth);  // base^2.4
}

double code_from_linear(double linear) {
  if (!(linear > 0.0031308)) return linear * 12.92;
  const double twelfth = root<3>(std::sqrt(std::sqrt(linear)));
  const double square = twelfth * twelfth;
  return 1.055 * (square * square * twelfth) - 0.055;  // linear^(1/2.4)
}

Rgb from_srgb(InterpolationSpace space, const Rgb& code) {
  switch (space) {
    case InterpolationSpace::srgb:
      break;
    case InterpolationSpace::linear:
      return rgb(linear_from_srgb(code));
    case InterpolationSpace::oklab:
      return rgb(oklab_from_linear(linear_from_srgb(code)));
  }
  return code;
}

Rgb to_srgb(InterpolationSpace space, const Rgb& color) {
  switch (space) {
    case InterpolationSpace::srgb:
      break;
    case InterpolationSpace::linear:
      return srgb_from_linear({color.r, color.g, color.b});
    case InterpolationSpace::oklab:
      return srgb_from_linear(linear_from_oklab(color));
  }
  return color;
}

}  // namespace sfumato
