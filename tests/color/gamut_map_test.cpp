// The mapping of colours into sRGB.
#include "color/gamut_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "color/constants.hpp"
#include "color/space.hpp"

namespace sfumato::color {
namespace {

Triple lab_of(const Rgb& color) {
  return oklab_from_xyz(xyz_from(Space::srgb, {color.r, color.g, color.b}));
}

TEST(GamutMap, colors_of_srgb_stay) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const Triple code = i < 8 ? Triple{i & 1 ? 1.0 : 0, i & 2 ? 1.0 : 0, i & 4 ? 1.0 : 0}
                              : Triple{share(random), share(random), share(random)};
    const SrgbColor mapped = map_to_srgb(xyz_from(Space::srgb, code));
    EXPECT_FALSE(mapped.is_mapped);
    EXPECT_NEAR(mapped.color.r, code.x, 1e-6);
    EXPECT_NEAR(mapped.color.g, code.y, 1e-6);
    EXPECT_NEAR(mapped.color.b, code.z, 1e-6);
  }
}

TEST(GamutMap, other_colors_keep_lightness_and_hue_within_what_is_seen) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double lightness = share(random), chroma = 0.6 * share(random);
    const double hue = 360 * share(random);
    const Triple wished = lab_from_lch(lightness, chroma, hue);
    const Rgb color = map_to_srgb(xyz_from_oklab(wished)).color;
    EXPECT_GE(std::min({color.r, color.g, color.b}), 0);
    EXPECT_LE(std::max({color.r, color.g, color.b}), 1);
    const Triple found = lab_of(color);
    const double across = (found.y * wished.z - found.z * wished.y) / std::max(chroma, 1e-9);
    EXPECT_LT(std::hypot(found.x - lightness, across), 0.0201) << lightness << ' ' << chroma;
  }
}

TEST(GamutMap, colors_lighter_than_white_are_white_and_darker_than_black_black) {
  EXPECT_EQ(map_to_srgb(xyz_from_oklab({1.2, 0.1, 0.1})).color, (Rgb{1, 1, 1}));
  EXPECT_EQ(map_to_srgb(xyz_from_oklab({-0.1, 0.1, 0.1})).color, (Rgb{0, 0, 0}));
}

TEST(GamutMap, rounding_of_what_was_written_is_no_mapping) {
  const Triple red = oklab_from_xyz(xyz_from(Space::srgb, {1, 0, 0}));
  EXPECT_FALSE(map_to_srgb(xyz_from_oklab({red.x, 1.001 * red.y, 1.001 * red.z})).is_mapped);
  EXPECT_TRUE(map_to_srgb(xyz_from_oklab({red.x, 1.02 * red.y, 1.02 * red.z})).is_mapped);
}

}  // namespace
}  // namespace sfumato::color
