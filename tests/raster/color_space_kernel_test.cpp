#include "raster/kernels/color_space_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sfumato::test {
namespace {

double clamped(double x) {
  return std::clamp(x, 0.0, 1.0);
}

TEST(RasterColorSpace, code_values_of_linear_light_are_within_1e_6) {
  double worst = 0;
  for (int i = 0; i <= 1 << 20; ++i) {
    const float linear = static_cast<float>(i) / (1 << 20);
    const Lanes<1> code = raster::code_from_linear_lanes(Lanes<1>(linear));
    worst = std::max(worst, std::fabs(code[0] - code_from_linear(linear)));
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(RasterColorSpace, code_values_of_oklab_are_within_2e_5) {
  double worst = 0;
  for (int i = 0; i < 40 * 40 * 40; ++i) {
    const Rgb lab{static_cast<float>(i % 40) / 39, static_cast<float>(i / 40 % 40) / 49 - 0.4f,
                  static_cast<float>(i / 1600) / 49 - 0.4f};
    const Rgb expected = to_srgb(InterpolationSpace::oklab, lab);
    const raster::Rgb3<4> code = raster::clamped_srgb<4>(
        InterpolationSpace::oklab, {Lanes<4>(lab.r), Lanes<4>(lab.g), Lanes<4>(lab.b)});
    worst = std::max({worst, std::fabs(code.r[0] - clamped(expected.r)),
                      std::fabs(code.g[1] - clamped(expected.g)),
                      std::fabs(code.b[2] - clamped(expected.b))});
  }
  EXPECT_LT(worst, 2e-5);
}

TEST(RasterColorSpace, black_and_white_stay_within_the_range) {
  for (InterpolationSpace space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
    for (const Rgb& code : {Rgb{0, 0, 0}, Rgb{1, 1, 1}}) {
      const Rgb color = from_srgb(space, code);
      const raster::Rgb3<1> back =
          raster::clamped_srgb<1>(space, {Lanes<1>(color.r), Lanes<1>(color.g), Lanes<1>(color.b)});
      for (float value : {back.r[0], back.g[0], back.b[0]}) {
        EXPECT_NEAR(value, code.r, 2e-6);
        EXPECT_GE(value, 0);
      }
    }
  }
}

}  // namespace
}  // namespace sfumato::test
