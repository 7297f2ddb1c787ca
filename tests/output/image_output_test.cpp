#include "output/image_output.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace sfumato::output {
namespace {

/// Returns random pixels, opaque.
Image opaque_image(int width, int height, PixelFormat format, std::uint32_t seed) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  std::mt19937 random(seed);
  const std::size_t bytes = static_cast<std::size_t>(bytes_per_channel(format));
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    const bool is_alpha = channel_count(format) == 4 && i / bytes % 4 == 3;
    image.bytes[i] = static_cast<std::uint8_t>(is_alpha ? 255 : random() % 256);
  }
  return image;
}

/// Returns its colours.
std::vector<std::uint8_t> without_alpha(const Image& image) {
  const std::size_t bytes = static_cast<std::size_t>(bytes_per_channel(image.format));
  std::vector<std::uint8_t> colors;
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    if (i / bytes % 4 != 3) colors.push_back(image.bytes[i]);
  return colors;
}

TEST(OpaqueAlpha, is_dropped_and_all_colors_stay) {
  Context context;
  for (const auto& [with, without] : {std::pair(PixelFormat::rgba8, PixelFormat::rgb8),
                                      std::pair(PixelFormat::rgba16, PixelFormat::rgb16)}) {
    for (int width = 1; width < 40; ++width) {
      Image image = opaque_image(width, 1 + width % 7, with, static_cast<std::uint32_t>(width));
      const std::vector<std::uint8_t> colors = without_alpha(image);
      ASSERT_TRUE(drop_opaque_alpha(context, image).ok());
      EXPECT_EQ(image.format, without);
      ASSERT_EQ(image.bytes, colors) << width;
    }
  }
}

TEST(OpaqueAlpha, stays_where_a_single_pixel_is_not_opaque) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgba8, PixelFormat::rgba16}) {
    const Image opaque = opaque_image(9, 5, format, 1);
    const std::size_t bytes = static_cast<std::size_t>(bytes_per_channel(format));
    for (std::size_t i = 0; i < opaque.bytes.size(); ++i) {
      if (i / bytes % 4 != 3) continue;
      Image image = opaque;
      image.bytes[i] = 254;
      const std::vector<std::uint8_t> before = image.bytes;
      ASSERT_TRUE(drop_opaque_alpha(context, image).ok());
      ASSERT_EQ(image.format, format) << i;
      ASSERT_EQ(image.bytes, before) << i;
    }
  }
}

TEST(OpaqueAlpha, of_an_image_without_alpha_is_no_matter) {
  Context context;
  Image image = opaque_image(8, 8, PixelFormat::rgb8, 1);
  const std::vector<std::uint8_t> before = image.bytes;
  ASSERT_TRUE(drop_opaque_alpha(context, image).ok());
  EXPECT_EQ(image.bytes, before);
}

TEST(OpaqueAlpha, is_left_to_whoever_cancels) {
  Context context;
  context.cancel = true;
  Image image = opaque_image(8, 8, PixelFormat::rgba8, 1);
  EXPECT_EQ(drop_opaque_alpha(context, image).code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::output
