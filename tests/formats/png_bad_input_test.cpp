// PNG files that are damaged, truncated or inconsistent.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "formats/png_chunks.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato {
namespace {

using test::Bytes;
using test::png_of;

Result<Image> decoded(const Bytes& png) {
  Context context;
  Result<Image> image = decode_png(context, png, "a.png");
  EXPECT_EQ(context.budget.used(), 0u);
  return image;
}

StatusCode code_of(const Bytes& png) {
  return decoded(png).status().code;
}

Bytes small_png() {
  return png_of(2, 2, 8, 2, {0, 1, 2, 3, 4, 5, 6, 0, 7, 8, 9, 10, 11, 12});
}

void expect_image(const Result<Image>& image, PixelFormat format, const Bytes& bytes) {
  ASSERT_TRUE(image.ok()) << to_string(image.status());
  EXPECT_EQ(image->format, format);
  EXPECT_EQ(image->bytes, bytes);
}

TEST(PngReading, true_colour_of_8_bits) {
  expect_image(decoded(small_png()), PixelFormat::rgb8, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
}

TEST(PngReading, gray_of_1_bit) {
  expect_image(decoded(png_of(3, 1, 1, 0, {0, 0b10100000})), PixelFormat::rgb8,
               {255, 255, 255, 0, 0, 0, 255, 255, 255});
}

TEST(PngReading, gray_with_alpha) {
  expect_image(decoded(png_of(1, 1, 8, 4, {0, 100, 50})), PixelFormat::rgba8, {100, 100, 100, 50});
}

TEST(PngReading, gray_of_16_bits) {
  const Result<Image> image = decoded(png_of(1, 1, 16, 0, {0, 0x12, 0x34}));
  const std::uint16_t value = 0x1234;
  Bytes bytes;
  for (int i = 0; i < 3; ++i) {
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), raw, raw + 2);
  }
  expect_image(image, PixelFormat::rgb16, bytes);
}

TEST(PngReading, palette) {
  expect_image(decoded(png_of(2, 1, 8, 3, {0, 1, 0}, {{"PLTE", {1, 2, 3, 4, 5, 6}}})),
               PixelFormat::rgb8, {4, 5, 6, 1, 2, 3});
}

TEST(PngReading, palette_with_transparency) {
  expect_image(
      decoded(png_of(2, 1, 4, 3, {0, 0x10}, {{"PLTE", {1, 2, 3, 4, 5, 6}}, {"tRNS", {255, 7}}})),
      PixelFormat::rgba8, {4, 5, 6, 7, 1, 2, 3, 255});
}

TEST(PngReading, empty_and_foreign_files_are_no_png_images) {
  EXPECT_EQ(code_of({}), StatusCode::bad_input);
  EXPECT_EQ(code_of({0x89, 'P', 'N', 'G'}), StatusCode::bad_input);
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg'/>";
  const Status status = decoded(Bytes(text.begin(), text.end())).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(to_string(status), "a.png: is a drawing or other XML; use a PNG");
}

TEST(PngReading, file_cut_short_anywhere_is_bad_input) {
  const Bytes png = small_png();
  for (std::size_t size = 0; size < png.size(); ++size) {
    EXPECT_EQ(code_of(Bytes(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(size))),
              StatusCode::bad_input)
        << size;
  }
}

TEST(PngReading, damage_to_any_byte_is_found) {
  const Bytes png = small_png();
  for (std::size_t i = 0; i < png.size(); ++i) {
    Bytes damaged = png;
    damaged[i] ^= 0x55;
    const StatusCode code = code_of(damaged);
    // A damaged header may ask for more than the limit.
    EXPECT_TRUE(code == StatusCode::bad_input || code == StatusCode::limit) << "byte " << i;
  }
}

TEST(PngReading, side_beyond_the_limit_is_refused_at_the_header) {
  const Status status = decoded(png_of(60'000, 60'000, 8, 2, Bytes(1000))).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status),
            "a.png: an image of 60000 × 60000 pixels; the limit is 16384 pixels on a side");
  EXPECT_EQ(status.limit, "image-side");
}

TEST(PngReading, header_that_lies_takes_no_memory) {
  Context context;
  new (&context.budget) Budget(1'000'000);
  const Bytes png = png_of(16'000, 16'000, 8, 2, Bytes(1000));
  EXPECT_EQ(decode_png(context, png, "a.png").status().code, StatusCode::bad_input);
}

TEST(PngReading, image_beyond_the_memory_budget_is_refused) {
  Context context;
  new (&context.budget) Budget(1'000'000);
  const Bytes png = png_of(1000, 1000, 8, 2, Bytes(3001 * 1000));
  EXPECT_EQ(decode_png(context, png, "a.png").status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(PngReading, too_few_rows_are_bad_input) {
  EXPECT_EQ(code_of(png_of(2, 2, 8, 2, {0, 1, 2, 3, 4, 5, 6})), StatusCode::bad_input);
}

TEST(PngReading, image_without_size_is_bad_input) {
  EXPECT_EQ(code_of(png_of(0, 2, 8, 2, {0, 0})), StatusCode::bad_input);
  EXPECT_EQ(code_of(png_of(2, 0, 8, 2, {0, 0})), StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato
