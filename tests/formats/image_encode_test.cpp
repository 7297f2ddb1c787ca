#include <gtest/gtest.h>
#include <webp/decode.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "codecs/jpeg/jpeg_decode.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato {
namespace {

/// Returns a smooth image with a sharp red and green diagonal of equal lightness, and alpha in
/// rgba8.
Image test_image(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  const auto channels = static_cast<std::size_t>(channel_count(format));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = &image.bytes[channels * (static_cast<std::size_t>(y) * width + x)];
      const bool below = x < y;
      pixel[0] = static_cast<std::uint8_t>(below ? 200 : 40);
      pixel[1] = static_cast<std::uint8_t>(below ? 60 : 140);
      pixel[2] = static_cast<std::uint8_t>(255 * x / width);
      if (channels == 4) pixel[3] = static_cast<std::uint8_t>(255 * y / height);
    }
  }
  return image;
}

/// Returns the mean difference of the first three channels, in code values.
double mean_difference(const Image& image, const std::uint8_t* rgba) {
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  double sum = 0;
  for (std::size_t i = 0; i < pixel_count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::abs(int{image.bytes[channels * i + c]} - int{rgba[4 * i + c]});
    }
  }
  return sum / (3.0 * static_cast<double>(pixel_count));
}

struct FreeWebp {
  void operator()(std::uint8_t* pixels) const { WebPFree(pixels); }
};
using WebpPixels = std::unique_ptr<std::uint8_t, FreeWebp>;

WebpPixels decoded(const std::vector<std::uint8_t>& file, int* width, int* height) {
  return WebpPixels(WebPDecodeRGBA(file.data(), file.size(), width, height));
}

TEST(JpegEncode, what_is_written_reads_back_nearly_the_same) {
  Context context;
  const Image image = test_image(93, 61, PixelFormat::rgb8);
  double previous = 1e9;
  for (const int quality : {30, 75, 95, 100}) {
    const auto file = encode_jpeg(context, image, quality);
    ASSERT_TRUE(file) << to_string(file.status());
    const auto back = codecs::decode_jpeg(context, *file);
    ASSERT_TRUE(back) << to_string(back.status());
    ASSERT_EQ(back->width, 93);
    ASSERT_EQ(back->height, 61);
    const double difference = mean_difference(image, back->rgba.data());
    EXPECT_LT(difference, previous) << quality;
    previous = difference;
  }
  // Colour has full resolution: the diagonal does not bleed.
  EXPECT_LT(previous, 0.6);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(JpegEncode, only_eight_bits_and_no_alpha) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgba8, PixelFormat::rgb16, PixelFormat::rgba16}) {
    Image image{8, 8, format, {}};
    image.bytes.resize(image.row_bytes() * 8);
    EXPECT_EQ(encode_jpeg(context, image, 90).status().code, StatusCode::bad_input);
  }
}

TEST(JpegEncode, keeps_to_the_budget_and_ends_when_it_is_told_to) {
  Context small{.budget = Budget(1000)};
  const Image image = test_image(64, 64, PixelFormat::rgb8);
  EXPECT_EQ(encode_jpeg(small, image, 90).status().code, StatusCode::limit);
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(encode_jpeg(cancelled, image, 90).status().code, StatusCode::cancelled);
  EXPECT_EQ(cancelled.budget.used(), 0u);
}

TEST(WebpEncode, lossless_keeps_every_byte) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8}) {
    const Image image = test_image(57, 83, format);
    const auto file = encode_webp(context, image, {.lossless = true});
    ASSERT_TRUE(file) << to_string(file.status());
    int width = 0, height = 0;
    const WebpPixels back = decoded(*file, &width, &height);
    ASSERT_TRUE(back);
    ASSERT_EQ(width, 57);
    ASSERT_EQ(height, 83);
    EXPECT_EQ(mean_difference(image, back.get()), 0);
    for (std::size_t i = 0; i < 57 * 83; ++i) {
      const int alpha = format == PixelFormat::rgba8 ? image.bytes[4 * i + 3] : 255;
      ASSERT_EQ(back.get()[4 * i + 3], alpha);
    }
  }
}

TEST(WebpEncode, lossy_is_near_and_smaller) {
  Context context;
  const Image image = test_image(200, 160, PixelFormat::rgb8);
  const auto fine = encode_webp(context, image, {.quality = 95});
  const auto coarse = encode_webp(context, image, {.quality = 40});
  ASSERT_TRUE(fine && coarse);
  EXPECT_LT(coarse->size(), fine->size());
  int width = 0, height = 0;
  const WebpPixels back = decoded(*fine, &width, &height);
  ASSERT_TRUE(back);
  EXPECT_LT(mean_difference(image, back.get()), 3);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(WebpEncode, says_what_it_cannot_hold) {
  Context context;
  Image deep{8, 8, PixelFormat::rgb16, {}};
  deep.bytes.resize(deep.row_bytes() * 8);
  EXPECT_EQ(encode_webp(context, deep, {}).status().code, StatusCode::bad_input);
  Image wide{kWebpSide + 1, 1, PixelFormat::rgb8, {}};
  wide.bytes.resize(wide.row_bytes());
  EXPECT_EQ(encode_webp(context, wide, {}).status().code, StatusCode::limit);
  Context small{.budget = Budget(1000)};
  EXPECT_EQ(encode_webp(small, test_image(64, 64, PixelFormat::rgb8), {}).status().code,
            StatusCode::limit);
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(encode_webp(cancelled, test_image(64, 64, PixelFormat::rgb8), {}).status().code,
            StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato
