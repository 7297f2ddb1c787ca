#include "sfumato/base/color_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sfumato {
namespace {

constexpr InterpolationSpace kSpaces[] = {InterpolationSpace::srgb, InterpolationSpace::linear,
                                          InterpolationSpace::oklab};

void expect_near(const Rgb& color, const Rgb& expected, double tolerance) {
  EXPECT_NEAR(color.r, expected.r, tolerance);
  EXPECT_NEAR(color.g, expected.g, tolerance);
  EXPECT_NEAR(color.b, expected.b, tolerance);
}

TEST(ColorSpace, linear_light_is_the_power_law_of_the_standard) {
  for (double code = 0; code <= 1.2; code += 1.0 / 4096) {
    const double expected = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(linear_from_code(code), expected, 1e-14);
  }
}

TEST(ColorSpace, code_values_are_the_power_law_of_the_standard) {
  for (double linear = 0; linear <= 1.2; linear += 1.0 / 4096) {
    const double expected =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    EXPECT_NEAR(code_from_linear(linear), expected, 1e-14);
  }
}

TEST(ColorSpace, every_8_bit_colour_of_a_grid_comes_back) {
  for (InterpolationSpace space : kSpaces) {
    for (int r = 0; r <= 255; r += 15) {
      for (int g = 0; g <= 255; g += 15) {
        for (int b = 0; b <= 255; b += 15) {
          const Rgb code{r / 255.0f, g / 255.0f, b / 255.0f};
          expect_near(to_srgb(space, from_srgb(space, code)), code,
                      space == InterpolationSpace::oklab ? 3e-6 : 2e-7);
        }
      }
    }
  }
}

TEST(ColorSpace, code_values_are_left_as_they_are) {
  const Rgb color{0.1f, -0.3f, 1.7f};
  EXPECT_EQ(from_srgb(InterpolationSpace::srgb, color), color);
  EXPECT_EQ(to_srgb(InterpolationSpace::srgb, color), color);
}

TEST(ColorSpace, black_and_white_are_the_ends_of_every_space) {
  for (InterpolationSpace space : kSpaces) EXPECT_EQ(from_srgb(space, {0, 0, 0}), (Rgb{0, 0, 0}));
  EXPECT_EQ(from_srgb(InterpolationSpace::linear, {1, 1, 1}), (Rgb{1, 1, 1}));
  expect_near(from_srgb(InterpolationSpace::oklab, {1, 1, 1}), {1, 0, 0}, 1e-6);
}

/// The values of CSS Color 4 for these colours.
TEST(ColorSpace, primaries_have_the_published_oklab_values) {
  const auto oklab = [](const Rgb& code) { return from_srgb(InterpolationSpace::oklab, code); };
  expect_near(oklab({1, 0, 0}), {0.62796f, 0.22486f, 0.12585f}, 2e-5);
  expect_near(oklab({0, 1, 0}), {0.86644f, -0.23389f, 0.17950f}, 2e-5);
  expect_near(oklab({0, 0, 1}), {0.45201f, -0.03246f, -0.31153f}, 2e-5);
}

TEST(ColorSpace, the_middle_of_black_and_white_is_as_bright_as_the_space_says) {
  EXPECT_NEAR(to_srgb(InterpolationSpace::linear, {0.5f, 0.5f, 0.5f}).r, 0.7353570, 1e-6);
  // Half of OKLab's lightness is an eighth of the light.
  EXPECT_NEAR(to_srgb(InterpolationSpace::oklab, {0.5f, 0, 0}).g, code_from_linear(0.125), 1e-6);
}

TEST(ColorSpace, colours_outside_the_range_give_numbers) {
  for (InterpolationSpace space : kSpaces) {
    for (float value : {-2.0f, -0.1f, 1.3f, 50.0f}) {
      const Rgb there = to_srgb(space, {value, value, -value});
      const Rgb back = from_srgb(space, {value, value, -value});
      for (float x : {there.r, there.g, there.b, back.r, back.g, back.b})
        EXPECT_TRUE(std::isfinite(x));
    }
  }
}

}  // namespace
}  // namespace sfumato
