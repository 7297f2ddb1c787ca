// Checks the flat art and the synthetic photo that measure traces.
#include "support/flat_art.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/planes.hpp"
#include "support/synthetic_photo.hpp"

namespace sfumato {
namespace {

class FlatArt : public testing::TestWithParam<std::string> {};

Image picture_of(const std::string& name, bool has_background) {
  Context context;
  const Result<Image> image = test::flat_picture(context, name, has_background);
  EXPECT_TRUE(image.ok()) << to_string(image.status());
  return image.ok() ? *image : Image{};
}

/// Returns the share of pixels that have the colour of their right and lower neighbours.
double even_share(const Image& image) {
  const test::Planes planes = test::planes_of(image);
  int even = 0;
  for (int y = 0; y + 1 < image.height; ++y) {
    for (int x = 0; x + 1 < image.width; ++x) {
      bool is_even = true;
      for (const test::Plane& plane : planes) {
        const float value = plane.at(x, y);
        is_even = is_even && plane.at(x + 1, y) == value && plane.at(x, y + 1) == value;
      }
      if (is_even) ++even;
    }
  }
  return even / (double{image.width - 1.0} * (image.height - 1));
}

TEST_P(FlatArt, is_drawn_in_flat_colors) {
  const Image image = picture_of(GetParam(), true);
  ASSERT_GE(image.width, 200);
  EXPECT_GT(even_share(image), 0.6);
  EXPECT_LT(even_share(image), 0.99);
}

TEST_P(FlatArt, lies_on_nothing_without_its_background) {
  const Image image = picture_of(GetParam(), false);
  ASSERT_EQ(image.format, PixelFormat::rgba8);
  const test::Planes white = test::planes_of(image, {1, 1, 1});
  const test::Planes black = test::planes_of(image, {0, 0, 0});
  int clear = 0, solid = 0;
  for (std::size_t i = 0; i < white[0].value.size(); ++i) {
    const float through = white[0].value[i] - black[0].value[i];
    if (through == 1) ++clear;
    if (through == 0) ++solid;
  }
  EXPECT_EQ(white[0].at(0, 0) - black[0].at(0, 0), 1.0F);
  EXPECT_GT(clear, image.width);
  EXPECT_GT(solid, image.width);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

INSTANTIATE_TEST_SUITE_P(All, FlatArt, testing::ValuesIn(test::flat_art_names()), name_of);

TEST(SyntheticPhoto, has_noise_of_two_code_values) {
  const test::Planes one = test::planes_of(test::synthetic_photo(240, 1));
  const test::Planes other = test::planes_of(test::synthetic_photo(240, 2));
  double squares = 0;
  for (std::size_t i = 0; i < one[1].value.size(); ++i) {
    squares += std::pow(255.0 * (double{one[1].value[i]} - double{other[1].value[i]}), 2);
  }
  const double deviation = std::sqrt(squares / 2 / static_cast<double>(one[1].value.size()));
  EXPECT_NEAR(deviation, 2, 0.1);
}

TEST(SyntheticPhoto, has_the_same_bytes_each_time) {
  EXPECT_EQ(test::synthetic_photo(120).bytes, test::synthetic_photo(120).bytes);
}

}  // namespace
}  // namespace sfumato
