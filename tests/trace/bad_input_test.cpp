// Nonsensical pictures and options give a valid drawing or an error.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/flat_art.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

/// Returns the picture whose pixel (x, y) has channel(x, y, c).
template <class Channel>
Image image_of(int width, int height, PixelFormat format, Channel channel) {
  Image image{width, height, format, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channel_count(format); ++c) {
        const auto value = static_cast<std::uint16_t>(channel(x, y, c));
        if (bytes_per_channel(format) == 1) {
          image.bytes.push_back(static_cast<std::uint8_t>(value));
        } else {
          const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
          image.bytes.insert(image.bytes.end(), bytes, bytes + 2);
        }
      }
    }
  }
  return image;
}

Image one_color(int width, int height, PixelFormat format = PixelFormat::rgb8) {
  return image_of(width, height, format, [](int, int, int c) { return 60 + 40 * c; });
}

TEST(TraceInput, may_be_of_any_size) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, {1, 2}, {2, 2}, {3, 3}, {5, 1}, {1, 300}, {300, 1}, {7, 11}}) {
    const Image picture = one_color(width, height);
    const Document drawing = test::trace_of(picture);
    EXPECT_EQ(test::curve_count(drawing), 1u) << width << " x " << height;
    EXPECT_GE(test::rendered_psnr_db(drawing, picture), 45) << width << " x " << height;
  }
}

TEST(TraceInput, may_be_as_narrow_as_a_picture_may_be_long) {
  for (const auto& [width, height] : {std::pair{1, 16'384}, {16'384, 1}}) {
    const Document drawing = test::trace_of(one_color(width, height));
    EXPECT_EQ(test::curve_count(drawing), 1u);
  }
}

TEST(TraceInput, is_at_most_as_large_as_an_image_may_be) {
  for (const auto& [width, height] : {std::pair{1, 20'000}, {20'000, 1}}) {
    Context context;
    const Result<Document> drawing = trace(context, one_color(width, height));
    EXPECT_EQ(drawing.status().code, StatusCode::limit);
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(TraceInput, must_be_a_picture) {
  Image shorter = one_color(4, 4);
  shorter.bytes.pop_back();
  for (const Image& picture : {Image{}, Image{-1, 4, PixelFormat::rgb8, {}}, shorter}) {
    Context context;
    EXPECT_EQ(trace(context, picture).status().code, StatusCode::bad_input);
  }
}

TEST(TraceInput, of_one_color_becomes_a_frame) {
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgb16}) {
    const Image picture = image_of(60, 40, format, [&](int, int, int c) {
      return (60 + 40 * c) * (bytes_per_channel(format) == 1 ? 1 : 257);
    });
    const Document drawing = test::trace_of(picture);
    EXPECT_EQ(test::curve_count(drawing), 1u);
    EXPECT_GE(test::rendered_psnr_db(drawing, picture), 50);
  }
}

TEST(TraceInput, of_16_bits_is_traced_as_that_of_8) {
  const Image photo = test::synthetic_photo(80);
  Image fine{photo.width, photo.height, PixelFormat::rgb16, {}};
  for (const std::uint8_t byte : photo.bytes) fine.bytes.insert(fine.bytes.end(), 2, byte);
  EXPECT_EQ(test::svg_of(test::trace_of(fine)), test::svg_of(test::trace_of(photo)));
}

TEST(TraceInput, of_pure_noise_is_traced_within_its_points) {
  std::mt19937 random(1);
  const Image noise =
      image_of(120, 90, PixelFormat::rgb8, [&](int, int, int) { return random() % 256; });
  const Document drawing = test::trace_of(noise, {.points = 300});
  EXPECT_LE(test::point_count(drawing), 300u);
  EXPECT_GE(test::rendered_psnr_db(drawing, noise), 10);
}

TEST(TraceInput, that_is_transparent_everywhere_becomes_a_drawing_of_nothing) {
  const Image clear =
      image_of(40, 30, PixelFormat::rgba8, [](int x, int, int c) { return c == 3 ? 0 : 5 * x; });
  const Document drawing = test::trace_of(clear);
  EXPECT_GE(test::rendered_psnr_db(drawing, clear, {1, 1, 1}), 45);
  EXPECT_GE(test::rendered_psnr_db(drawing, clear, {0, 0, 0}), 45);
}

TEST(TraceInput, whose_alpha_is_full_has_no_opacity) {
  const Image photo = test::synthetic_photo(80);
  Image opaque{photo.width, photo.height, PixelFormat::rgba8, {}};
  for (std::size_t i = 0; i < photo.bytes.size(); i += 3) {
    opaque.bytes.insert(opaque.bytes.end(), photo.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                        photo.bytes.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    opaque.bytes.push_back(255);
  }
  EXPECT_EQ(test::svg_of(test::trace_of(opaque)), test::svg_of(test::trace_of(photo)));
}

TEST(TraceOptions, out_of_range_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<TraceOptions> wrong{
      {.points = -1},        {.max_curves = -1},        {.psnr_db = -1},      {.psnr_db = nan},
      {.psnr_db = infinite}, {.max_seconds = -1},       {.max_seconds = nan}, {.smooth_px = -1},
      {.smooth_px = nan},    {.smooth_px = 32.001},     {.smooth_px = 1e9},   {.max_side = 0},
      {.max_side = -5},      {.max_seconds = infinite},
  };
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    Context context;
    const Result<Document> drawing = trace(context, one_color(8, 8), wrong[i]);
    EXPECT_EQ(drawing.status().code, StatusCode::bad_input) << i;
    EXPECT_FALSE(drawing.status().message.empty()) << i;
  }
}

TEST(TraceOptions, may_be_as_large_as_they_like) {
  const Image photo = test::synthetic_photo(40);
  const int most = std::numeric_limits<int>::max();
  for (const TraceOptions& options :
       std::vector<TraceOptions>{{.points = most},
                                 {.max_curves = most},
                                 {.psnr_db = 1e9},
                                 {.max_seconds = 1e9},
                                 {.smooth_px = TraceOptions::kMostSmooth},
                                 {.max_side = most},
                                 {.max_side = 1},
                                 {.seed = std::numeric_limits<std::uint64_t>::max()}}) {
    test::trace_of(photo, options);
  }
}

TEST(TraceOptions, may_be_of_no_kind_that_there_is) {
  const Image photo = test::synthetic_photo(40);
  test::trace_of(photo, {.blur = static_cast<TraceBlur>(77), .stops = static_cast<TraceStops>(77)});
}

}  // namespace
}  // namespace sfumato
