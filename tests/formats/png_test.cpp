#include "sfumato/codecs/png.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <random>
#include <string>

#include "sfumato/base/limits.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato {
namespace {

constexpr PixelFormat kFormats[] = {PixelFormat::rgb8, PixelFormat::rgba8, PixelFormat::rgb16,
                                    PixelFormat::rgba16};

/// Returns a pseudo-random number that depends only on the index.
std::uint32_t hashed(std::uint32_t index) {
  index = (index ^ (index >> 16)) * 0x45d9f3bu;
  index = (index ^ (index >> 16)) * 0x45d9f3bu;
  return index ^ (index >> 16);
}

Image blank_image(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(height));
  return image;
}

/// Returns noise without repetitions, so that blocks are stored uncompressed.
Image noise(int width, int height, PixelFormat format) {
  Image image = blank_image(width, height, format);
  std::uint32_t index = 0;
  for (std::uint8_t& byte : image.bytes) byte = static_cast<std::uint8_t>(hashed(++index));
  return image;
}

/// Returns smooth areas, flat areas, edges and a little noise.
Image drawing(int width, int height, PixelFormat format) {
  Image image = blank_image(width, height, format);
  const std::size_t pixel_bytes = image.row_bytes() / static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < image.bytes.size(); ++i) {
    const std::size_t y = i / image.row_bytes();
    const std::size_t x = i % image.row_bytes() / pixel_bytes;
    std::size_t value = (x * x + 3 * y * y) / 900 + 40 * (i % pixel_bytes);
    if (x % 90 > 60) value = 17;
    if (y % 70 > 60) value = hashed(static_cast<std::uint32_t>(i)) % 3;
    image.bytes[i] = static_cast<std::uint8_t>(value);
  }
  return image;
}

std::vector<std::uint8_t> encoded(const Image& image) {
  Context context;
  Result<std::vector<std::uint8_t>> png = encode_png(context, image);
  EXPECT_TRUE(png.ok()) << to_string(png.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return png ? std::move(*png) : std::vector<std::uint8_t>();
}

void expect_round_trip(const Image& image) {
  Context context;
  const Result<Image> back = decode_png(context, encoded(image), "a.png");
  ASSERT_TRUE(back.ok()) << to_string(back.status());
  EXPECT_EQ(back->width, image.width);
  EXPECT_EQ(back->height, image.height);
  EXPECT_EQ(back->format, image.format);
  EXPECT_TRUE(back->bytes == image.bytes);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Png, every_format_and_odd_size_comes_back_as_it_was) {
  const std::pair<int, int> sizes[] = {{1, 1},   {1, 9},    {9, 1},     {7, 3},     {2, 2},
                                       {64, 64}, {333, 41}, {1000, 70}, {5000, 30}, {16'384, 5}};
  for (const PixelFormat format : kFormats) {
    for (const auto& [width, height] : sizes) {
      SCOPED_TRACE(std::to_string(static_cast<int>(format)) + ": " + std::to_string(width) + " × " +
                   std::to_string(height));
      expect_round_trip(blank_image(width, height, format));
      expect_round_trip(noise(width, height, format));
      expect_round_trip(drawing(width, height, format));
    }
  }
}

/// Returns rows in bands: noise, one colour, gradients with and without dither; all from the seed.
Image random_image(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto side = [&random] { return 1 + static_cast<int>(random() % (1u << (random() % 11))); };
  const int width = side(), height = side();
  Image image = blank_image(width, height, kFormats[random() % std::size(kFormats)]);
  const std::size_t channels = static_cast<std::size_t>(channel_count(image.format));
  const std::size_t row = image.row_bytes();
  for (std::size_t begin = 0; begin < image.bytes.size();) {
    const std::size_t rows = 1 + random() % (1u << (random() % 8));
    const std::size_t end = std::min(image.bytes.size(), begin + rows * row);
    const unsigned kind = random() % 4, slope = 1 + random() % 50, color = random();
    for (; begin < end; ++begin) {
      unsigned value = color >> (8 * (begin % channels));
      if (kind == 1) value = random();
      if (kind > 1) value = static_cast<unsigned>(begin % row + begin / row) / slope;
      if (kind == 3) value += random() % 2;
      image.bytes[begin] = static_cast<std::uint8_t>(value);
    }
  }
  return image;
}

TEST(Png, any_image_comes_back_as_it_was) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_round_trip(random_image(seed));
  }
}

TEST(Png, image_of_many_waves_of_stripes_comes_back_as_it_was) {
  expect_round_trip(drawing(3000, 3000, PixelFormat::rgba8));
}

TEST(Png, bytes_are_the_same_for_any_number_of_threads) {
  std::vector<Image> images{drawing(1500, 4000, PixelFormat::rgb8)};  // waves of stripes
  for (const PixelFormat format : kFormats) images.push_back(drawing(700, 500, format));
  for (const Image& image : images) {
    const std::vector<std::uint8_t> expected = encoded(image);
    for (const int thread_count : {1, 2, 3, 8}) {
      ThreadPool executor(thread_count);
      Context context;
      context.executor = &executor;
      const Result<std::vector<std::uint8_t>> png = encode_png(context, image);
      ASSERT_TRUE(png.ok());
      EXPECT_TRUE(*png == expected) << thread_count << " threads";
    }
  }
}

TEST(Png, noise_grows_by_less_than_a_hundredth) {
  const Image image = noise(1000, 300, PixelFormat::rgb8);
  EXPECT_LT(encoded(image).size(), image.bytes.size() * 101 / 100);
}

TEST(Png, one_colour_shrinks_to_less_than_a_hundredth) {
  const Image image = blank_image(1000, 300, PixelFormat::rgb8);
  EXPECT_LT(encoded(image).size(), image.bytes.size() / 100);
}

TEST(Png, says_that_it_is_srgb) {
  const std::vector<std::uint8_t> png = encoded(blank_image(3, 2, PixelFormat::rgb8));
  const std::string_view text(reinterpret_cast<const char*>(png.data()), png.size());
  EXPECT_NE(text.find("sRGB"), std::string_view::npos);
  EXPECT_EQ(text.find("tIME"), std::string_view::npos);
}

TEST(Png, cancelled_writing_gives_no_image) {
  Context context;
  context.cancel = true;
  EXPECT_EQ(encode_png(context, blank_image(9, 9, PixelFormat::rgb8)).status().code,
            StatusCode::cancelled);
}

TEST(Png, image_beyond_the_limit_is_not_written) {
  Context context;
  EXPECT_EQ(
      encode_png(context, blank_image(limits::kImageSide + 1, 1, PixelFormat::rgb8)).status().code,
      StatusCode::limit);
}

TEST(Png, writing_stays_within_the_memory_budget) {
  Context context;
  new (&context.budget) Budget(100'000);
  EXPECT_EQ(encode_png(context, blank_image(300, 300, PixelFormat::rgb8)).status().code,
            StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(Png, image_whose_bytes_do_not_match_its_size_is_refused) {
  Image image = blank_image(3, 3, PixelFormat::rgb8);
  image.bytes.pop_back();
  Context context;
  EXPECT_EQ(encode_png(context, image).status().code, StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato
