// Large pictures that are reduced while they are read.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "codecs/photo/photo.hpp"
#include "codecs/png/png_decode.hpp"
#include "formats/photo_files.hpp"
#include "formats/png_chunks.hpp"

namespace sfumato {
namespace {

using test::Bytes;

constexpr std::size_t kWidth = 53, kHeight = 37;
constexpr std::size_t kChannels = 4;

/// Returns 16-bit code values, row by row, or by the passes of Adam7.
Bytes rows_of(const std::vector<std::uint16_t>& samples, bool is_interlaced) {
  struct Pass {
    std::size_t x, y, dx, dy;
  };
  std::vector<Pass> passes{{0, 0, 1, 1}};
  if (is_interlaced) {
    passes = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  }
  Bytes rows;
  for (const Pass& pass : passes) {
    for (std::size_t y = pass.y; y < kHeight; y += pass.dy) {
      rows.push_back(0);
      for (std::size_t x = pass.x; x < kWidth; x += pass.dx) {
        for (std::size_t c = 0; c < kChannels; ++c) {
          const std::uint16_t value = samples[kChannels * (y * kWidth + x) + c];
          rows.push_back(static_cast<std::uint8_t>(value >> 8));
          rows.push_back(static_cast<std::uint8_t>(value));
        }
      }
    }
  }
  return rows;
}

/// Returns the overlap of a smaller pixel with a pixel on one axis.
double overlap(std::size_t small, std::size_t small_count, std::size_t at, std::size_t count) {
  const double ratio = static_cast<double>(count) / static_cast<double>(small_count);
  const double from = std::max(static_cast<double>(small) * ratio, static_cast<double>(at));
  const double to = std::min(static_cast<double>(small + 1) * ratio, static_cast<double>(at + 1));
  return std::max(to - from, 0.0) / ratio;
}

std::array<double, kChannels> mean_of(const std::vector<std::uint16_t>& samples, std::size_t x,
                                      std::size_t y, const Image& out) {
  std::array<double, kChannels> sum{};
  for (std::size_t j = 0; j < kHeight; ++j) {
    const double rows = overlap(y, static_cast<std::size_t>(out.height), j, kHeight);
    for (std::size_t i = 0; i < kWidth; ++i) {
      const double share = rows * overlap(x, static_cast<std::size_t>(out.width), i, kWidth);
      const std::uint16_t* pixel = &samples[kChannels * (j * kWidth + i)];
      const double alpha = pixel[3] / 65535.0;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += share * alpha * pixel[c];
      sum[3] += share * pixel[3];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) sum[c] /= std::max(sum[3] / 65535, 1e-9);
  return sum;
}

TEST(PhotoShrink, a_pixel_is_the_mean_of_what_it_covers_interlaced_or_not) {
  std::mt19937 random(7);
  std::vector<std::uint16_t> samples(kChannels * kWidth * kHeight);
  for (std::uint16_t& sample : samples) sample = static_cast<std::uint16_t>(random());
  for (const bool is_interlaced : {false, true}) {
    const Bytes png = test::png_of(kWidth, kHeight, 16, 6, rows_of(samples, is_interlaced), {}, {},
                                   is_interlaced);
    for (const int side : {1, 17, 40, 52}) {
      Context context;
      const auto photo = codecs::decode_png_photo(context, png, "a.png", {side, 0});
      ASSERT_TRUE(photo.ok()) << to_string(photo.status());
      EXPECT_EQ(photo->width, static_cast<int>(kWidth));
      const Image& out = photo->image;
      ASSERT_EQ(out.format, PixelFormat::rgba16);
      EXPECT_EQ(out.width, side);
      for (std::size_t i = 0; i < out.bytes.size() / 8; ++i) {
        const auto columns = static_cast<std::size_t>(out.width);
        const auto mean = mean_of(samples, i % columns, i / columns, out);
        std::uint16_t pixel[kChannels];
        std::memcpy(pixel, &out.bytes[8 * i], 8);
        for (std::size_t c = 0; c < kChannels; ++c) EXPECT_NEAR(pixel[c], mean[c], 0.51);
      }
      EXPECT_EQ(context.budget.used(), 0u);
    }
  }
}

TEST(PhotoShrink, pictures_of_every_kind_shrink_to_their_one_colour) {
  struct Kind {
    int depth, color_type;
    Bytes pixel;
    std::array<int, 3> color;
  };
  const Kind kinds[] = {{8, 0, {77}, {77, 77, 77}},
                        {16, 0, {77, 77}, {77, 77, 77}},
                        {8, 2, {9, 80, 200}, {9, 80, 200}},
                        {16, 2, {9, 9, 80, 80, 200, 200}, {9, 80, 200}},
                        {8, 4, {77, 255}, {77, 77, 77}}};
  for (const Kind& kind : kinds) {
    Bytes rows;
    for (int y = 0; y < 20; ++y) {
      rows.push_back(0);
      for (int x = 0; x < 30; ++x) {
        rows.insert(rows.end(), kind.pixel.begin(), kind.pixel.end());
      }
    }
    Context context;
    const auto photo = codecs::decode_png_photo(
        context, test::png_of(30, 20, kind.depth, kind.color_type, rows), "a.png", {7, 0});
    ASSERT_TRUE(photo.ok()) << to_string(photo.status());
    const Image& out = photo->image;
    EXPECT_EQ(out.width, 7);
    EXPECT_EQ(out.height, 5);
    const auto channels = static_cast<std::size_t>(channel_count(out.format));
    EXPECT_EQ(channels, kind.color_type == 4 ? 4u : 3u);
    for (std::size_t i = 0; i < out.bytes.size() / 2; ++i) {
      std::uint16_t value;
      std::memcpy(&value, &out.bytes[2 * i], 2);
      EXPECT_EQ(value, i % channels < 3 ? 257 * kind.color[i % channels] : 65535);
    }
  }
}

TEST(PhotoShrink, a_large_png_takes_the_memory_of_the_small_one) {
  constexpr std::uint32_t kSide = 3000;  // 69 MiB
  const Bytes png = test::png_of(kSide, kSide, 16, 6, Bytes((8 * kSide + 1) * kSide));
  for (const int side : {64, 512}) {
    Context context{.budget = Budget(std::size_t{12} << 20)};
    const auto photo = codecs::read_sized_photo(context, png, "a.png", side);
    ASSERT_TRUE(photo.ok()) << to_string(photo.status());
    EXPECT_EQ(photo->image.width, side);
    EXPECT_EQ(photo->width, static_cast<int>(kSide));
    EXPECT_EQ(codecs::read_photo(context, png, "a.png").status().limit, "memory");
  }
  Context context;
  const auto whole = codecs::read_sized_photo(context, png, "a.png", 4000);
  ASSERT_TRUE(whole.ok()) << to_string(whole.status());
  EXPECT_EQ(whole->image.width, static_cast<int>(kSide));
}

TEST(PhotoShrink, a_picture_on_its_side_has_the_size_it_stands_upright_with) {
  constexpr std::uint32_t kWide = 12'000, kHigh = 1000;
  Bytes rows((8 * kWide + 1) * kHigh, 0);
  const Bytes png = test::png_of(kWide, kHigh, 16, 6, rows, {{"eXIf", test::exif_of(6)}});
  Context context;
  const auto photo = codecs::read_sized_photo(context, png, "a.png", 120);
  ASSERT_TRUE(photo.ok()) << to_string(photo.status());
  EXPECT_EQ(photo->width, static_cast<int>(kHigh));
  EXPECT_EQ(photo->height, static_cast<int>(kWide));
  EXPECT_EQ(photo->image.width, 10);
  EXPECT_EQ(photo->image.height, 120);
}

}  // namespace
}  // namespace sfumato
