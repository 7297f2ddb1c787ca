// Colour spaces against closed forms and published values.
#include "color/space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "color/constants.hpp"
#include "color/transfer.hpp"

namespace sfumato::color {
namespace {

/// Returns sRGB code values, outside 0 to 1 for colours outside sRGB.
Triple srgb_from_xyz(const Triple& xyz) {
  const Triple linear = linear_srgb_from_xyz(xyz);
  return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

void expect_near(const Triple& value, const Triple& expected, double tolerance) {
  EXPECT_NEAR(value.x, expected.x, tolerance);
  EXPECT_NEAR(value.y, expected.y, tolerance);
  EXPECT_NEAR(value.z, expected.z, tolerance);
}

TEST(Transfer, functions_are_the_powers_of_css) {
  for (double code = 0; code <= 1.5; code += 1.0 / 1024) {
    EXPECT_NEAR(linear_from_a98(code), std::pow(code, 563.0 / 256), 1e-14);
    EXPECT_NEAR(linear_from_rec2020(code), std::pow(code, 2.4), 1e-14);
    const double prophoto = code <= 1.0 / 32 ? code / 16 : std::pow(code, 1.8);
    EXPECT_NEAR(linear_from_prophoto(code), prophoto, 1e-14);
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(code)), code, 1e-6);
  }
}

TEST(Transfer, functions_are_odd) {
  for (const double code : {0.01, 0.3, 1.0, 2.0}) {
    EXPECT_EQ(linear_from_srgb(-code), -linear_from_srgb(code));
    EXPECT_EQ(srgb_from_linear(-code), -srgb_from_linear(code));
    EXPECT_EQ(linear_from_a98(-code), -linear_from_a98(code));
    EXPECT_EQ(linear_from_prophoto(-code), -linear_from_prophoto(code));
    EXPECT_EQ(linear_from_rec2020(-code), -linear_from_rec2020(code));
  }
}

TEST(ColorSpaces, white_of_each_space_is_white) {
  for (const Space space :
       {Space::srgb, Space::srgb_linear, Space::display_p3, Space::display_p3_linear,
        Space::a98_rgb, Space::prophoto_rgb, Space::rec2020}) {
    expect_near(xyz_from(space, {1, 1, 1}), xyz_of(kD65), 1e-12);
  }
  expect_near(xyz_from(Space::xyz_d50, xyz_of(kD50)), xyz_of(kD65), 1e-12);
  expect_near(xyz_from_lab({100, 0, 0}), xyz_of(kD65), 1e-12);
  expect_near(xyz_from_oklab({1, 0, 0}), xyz_of(kD65), 1e-6);
}

TEST(ColorSpaces, matrix_of_srgb_is_that_of_css) {
  EXPECT_NEAR(kXyzFromSrgb.row[0].x, 0.41239079926595934, 1e-12);
  EXPECT_NEAR(kXyzFromSrgb.row[1].y, 0.715168678767756, 1e-12);
  EXPECT_NEAR(kXyzFromSrgb.row[2].z, 0.9505321522496607, 1e-12);
  EXPECT_NEAR(kD65FromD50.row[0].x, 0.955473421488075, 1e-5);
}

TEST(ColorSpaces, oklab_leads_there_and_back) {
  for (const Triple& lab : {Triple{0.5, 0.1, -0.1}, Triple{0.01, -0.3, 0.2}, Triple{1.5, 2, 3}}) {
    expect_near(oklab_from_xyz(xyz_from_oklab(lab)), lab, 1e-12);
  }
}

TEST(ColorSpaces, colors_outside_srgb_keep_their_place) {
  expect_near(srgb_from_xyz(xyz_from(Space::display_p3, {0, 1, 0})),
              {-0.511605, 1.018266, -0.310675}, 1e-6);
  expect_near(srgb_from_xyz(xyz_from(Space::rec2020, {0.4, 0.7, 0.2})),
              {-0.287148, 0.713410, -0.156937}, 1e-6);
  expect_near(srgb_from_xyz(xyz_from(Space::a98_rgb, {0.2, 0.6, 0.3})),
              {-0.329927, 0.605638, 0.271444}, 1e-6);
  expect_near(srgb_from_xyz(xyz_from(Space::prophoto_rgb, {0.3, 0.5, 0.7})),
              {-0.406450, 0.606333, 0.777502}, 1e-6);
  expect_near(srgb_from_xyz(xyz_from_oklab(lab_from_lch(0.9, 0.4, 150))),
              {-0.668062, 1.117984, -0.211872}, 1e-6);
}

TEST(ColorSpaces, a_hue_is_an_angle) {
  for (const double degrees : {0.0, 33.0, 90.0, 200.0, 359.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    expect_near(lab_from_lch(0.5, 2, degrees), {0.5, 2 * std::cos(angle), 2 * std::sin(angle)},
                1e-14);
  }
}

}  // namespace
}  // namespace sfumato::color
