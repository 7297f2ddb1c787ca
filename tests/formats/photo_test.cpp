// Photos as people see them: kinds of files, orientation, and damaged files.
#include "codecs/photo/photo.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>

#include "formats/image_files.hpp"
#include "formats/photo_files.hpp"
#include "formats/photo_support.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato {
namespace {

using namespace test;

Image gradient(int width, int height, PixelFormat format) {
  Image image{width, height, format, {}};
  for (std::size_t i = 0; i < image.row_bytes() * static_cast<std::size_t>(height); ++i) {
    image.bytes.push_back(static_cast<std::uint8_t>(i / 7));
  }
  return image;
}

/// Returns rows of gray pixels, one digit per pixel.
Bytes digits_png(const std::vector<std::string>& rows, const std::vector<PngChunk>& before,
                 const std::vector<PngChunk>& after = {}) {
  Bytes samples;
  for (const std::string& row : rows) {
    samples.push_back(0);
    samples.insert(samples.end(), row.begin(), row.end());
  }
  return png_of(static_cast<std::uint32_t>(rows[0].size()), static_cast<std::uint32_t>(rows.size()),
                8, 0, samples, before, after);
}

std::vector<std::string> digits_of(const Image& image) {
  std::vector<std::string> rows;
  for (int y = 0; y < image.height; ++y) {
    rows.emplace_back();
    for (int x = 0; x < image.width; ++x) {
      rows.back() += static_cast<char>(image.bytes[3 * (y * image.width + x)]);
    }
  }
  return rows;
}

/// How a camera stores 123 / 456 in each orientation, 1 to 8.
const std::vector<std::vector<std::string>> kStored{
    {"123", "456"},     {"321", "654"},     {"654", "321"},     {"456", "123"},
    {"14", "25", "36"}, {"36", "25", "14"}, {"63", "52", "41"}, {"41", "52", "63"}};

TEST(PhotoOrientation, every_one_stands_upright_in_png_of_either_byte_order) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const bool is_big_endian : {false, true}) {
      const PngChunk exif{"eXIf", exif_of(orientation, is_big_endian)};
      const auto& stored = kStored[static_cast<std::size_t>(orientation - 1)];
      for (const Bytes& file : {digits_png(stored, {exif}), digits_png(stored, {}, {exif})}) {
        Warnings warnings;
        const Result<Image> image = photo_in(file, &warnings);
        ASSERT_TRUE(image.ok()) << to_string(image.status());
        EXPECT_EQ(digits_of(*image), kStored[0]) << orientation;
        EXPECT_TRUE(warnings.empty());
      }
    }
  }
}

TEST(PhotoOrientation, every_one_stands_upright_in_webp) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const auto& stored = kStored[static_cast<std::size_t>(orientation - 1)];
    const int width = static_cast<int>(stored[0].size()), height = static_cast<int>(stored.size());
    Image image{width, height, PixelFormat::rgb8, {}};
    for (const std::string& row : stored) {
      for (const char digit : row) image.bytes.insert(image.bytes.end(), 3, std::uint8_t(digit));
    }
    Context context;
    const auto webp = encode_webp(context, image, {.lossless = true});
    ASSERT_TRUE(webp.ok());
    const Bytes exif = exif_of(orientation);
    Bytes named{'E', 'x', 'i', 'f', 0, 0};
    named.insert(named.end(), exif.begin(), exif.end());
    for (const Bytes& data : {exif, named}) {
      const Result<Image> photo = photo_in(webp_with(*webp, {}, data, width, height));
      ASSERT_TRUE(photo.ok()) << to_string(photo.status());
      EXPECT_EQ(digits_of(*photo), kStored[0]) << orientation;
    }
  }
}

/// Squares of 16 pixels, each lighter than the previous one.
TEST(PhotoOrientation, every_one_stands_upright_in_jpeg) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const auto& stored = kStored[static_cast<std::size_t>(orientation - 1)];
    const int width = static_cast<int>(stored[0].size()), height = static_cast<int>(stored.size());
    Image image{16 * width, 16 * height, PixelFormat::rgb8, {}};
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const int level = 30 * (stored[static_cast<std::size_t>(y / 16)][x / 16] - '0');
        image.bytes.insert(image.bytes.end(), 3, static_cast<std::uint8_t>(level));
      }
    }
    Context context;
    const auto jpeg = encode_jpeg(context, image, 100);
    ASSERT_TRUE(jpeg.ok());
    const Result<Image> photo = photo_in(with_exif(*jpeg, exif_of(orientation)));
    ASSERT_TRUE(photo.ok()) << to_string(photo.status());
    ASSERT_EQ(photo->width, 48);
    ASSERT_EQ(photo->height, 32);
    for (int digit = 1; digit <= 6; ++digit) {
      const int x = 8 + 16 * ((digit - 1) % 3), y = 8 + 16 * ((digit - 1) / 3);
      EXPECT_NEAR(photo->bytes[3 * static_cast<std::size_t>(y * 48 + x)], 30 * digit, 2)
          << orientation;
    }
  }
}

TEST(PhotoOrientation, sixteen_bits_and_alpha_are_turned_with_their_pixels) {
  // Two horizontal neighbours, stored one below the other.
  const Bytes rows{0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 11, 12, 13, 14, 15, 16, 17, 18};
  const Result<Image> image = photo_in(png_of(1, 2, 16, 6, rows, {{"eXIf", exif_of(8)}}));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->format, PixelFormat::rgba16);
  EXPECT_EQ(image->width, 2);
  std::vector<std::uint16_t> values(8);
  std::memcpy(values.data(), image->bytes.data(), 16);
  EXPECT_EQ(values, (std::vector<std::uint16_t>{0x0102, 0x0304, 0x0506, 0x0708, 0x0B0C, 0x0D0E,
                                                0x0F10, 0x1112}));
}

TEST(PhotoOrientation, damaged_exif_is_ignored_with_a_warning) {
  std::vector<Bytes> damaged;
  const Bytes whole = exif_of(6);
  for (std::size_t size = 1; size < 34; ++size) {  // the orientation ends there
    damaged.emplace_back(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
  }
  for (const int orientation : {0, 9, 65535}) damaged.push_back(exif_of(orientation));
  Bytes far = whole, other = whole, of_text = whole;
  far[4] = far[5] = far[6] = far[7] = 0xFF;
  other[2] = 43;
  of_text[24] = 2;
  damaged.insert(damaged.end(), {far, other, of_text});
  const Bytes jpeg = jpeg_file(16, 8, 3, {10, 20, 30, 0});
  for (const Bytes& exif : damaged) {
    Warnings warnings;
    const Result<Image> image = photo_in(with_exif(jpeg, exif), &warnings);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 16);
    ASSERT_EQ(warnings.size(), 1u) << exif.size();
    EXPECT_EQ(to_string(warnings[0]),
              "a.file: the orientation is ignored: the EXIF data are damaged");
  }
}

TEST(PhotoOrientation, exif_that_says_nothing_of_it_is_no_damage) {
  Bytes silent = exif_of(6);
  silent[22] = 0x13;
  Warnings warnings;
  const Result<Image> image =
      photo_in(with_exif(jpeg_file(16, 8, 3, {10, 20, 30, 0}), silent), &warnings);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 16);
  EXPECT_TRUE(warnings.empty());
}

TEST(Photo, palettes_and_gray_are_colours_and_alpha_stays) {
  const auto expect = [](const Bytes& file, PixelFormat format, const Bytes& bytes) {
    const Result<Image> image = photo_in(file);
    ASSERT_TRUE(image.ok()) << to_string(image.status());
    EXPECT_EQ(image->format, format);
    EXPECT_EQ(image->bytes, bytes);
  };
  const PngChunk palette{"PLTE", {1, 2, 3, 4, 5, 6}};
  expect(png_of(2, 1, 8, 3, {0, 1, 0}, {palette}), PixelFormat::rgb8, {4, 5, 6, 1, 2, 3});
  expect(png_of(2, 1, 1, 3, {0, 0x80}, {palette, {"tRNS", {9}}}), PixelFormat::rgba8,
         {4, 5, 6, 255, 1, 2, 3, 9});
  expect(png_of(1, 1, 8, 4, {0, 100, 50}), PixelFormat::rgba8, {100, 100, 100, 50});
  expect(png_of(2, 1, 8, 2, {0, 1, 2, 3, 4, 5, 6}), PixelFormat::rgb8, {1, 2, 3, 4, 5, 6});
}

TEST(Photo, gray_of_16_bits_keeps_them) {
  const Result<Image> image = photo_in(png_of(1, 1, 16, 4, {0, 0x12, 0x34, 0x56, 0x78}));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->format, PixelFormat::rgba16);
  std::vector<std::uint16_t> values(4);
  std::memcpy(values.data(), image->bytes.data(), 8);
  EXPECT_EQ(values, (std::vector<std::uint16_t>{0x1234, 0x1234, 0x1234, 0x5678}));
}

TEST(Photo, webp_of_either_kind_is_read) {
  Context context;
  for (const PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8}) {
    const Image image = gradient(40, 30, format);
    const auto lossless = encode_webp(context, image, {.lossless = true});
    ASSERT_TRUE(lossless.ok());
    const Result<Image> same = photo_in(*lossless);
    ASSERT_TRUE(same.ok()) << to_string(same.status());
    EXPECT_EQ(same->format, format);
    EXPECT_EQ(same->bytes, image.bytes);
    const auto lossy = encode_webp(context, image, {});
    ASSERT_TRUE(lossy.ok());
    const Result<Image> near = photo_in(*lossy);
    ASSERT_TRUE(near.ok()) << to_string(near.status());
    EXPECT_EQ(near->format, format);
    ASSERT_EQ(near->bytes.size(), image.bytes.size());
    if (format == PixelFormat::rgb8) {
      EXPECT_NEAR(near->bytes[0], image.bytes[0], 8);
    }
    for (std::size_t i = 3; format == PixelFormat::rgba8 && i < image.bytes.size(); i += 4) {
      EXPECT_EQ(near->bytes[i], image.bytes[i]);
    }
  }
}

/// Returns a file of each kind, with all parts that the reader examines.
std::vector<Bytes> whole_files() {
  Context context;
  const Image image = gradient(64, 48, PixelFormat::rgba8);
  const auto lossy = encode_webp(context, image, {});
  const auto lossless = encode_webp(context, image, {.lossless = true});
  EXPECT_TRUE(lossy.ok() && lossless.ok());
  Bytes rows;
  for (int i = 0; i < 48 * (1 + 64 * 6); ++i) {
    rows.push_back(static_cast<std::uint8_t>(i % 385 == 0 ? 0 : i * i));
  }
  const Bytes p3 = display_p3_profile(), exif = exif_of(6);
  return {png_of(64, 48, 16, 2, rows, {{"iCCP", png_profile(p3)}, {"eXIf", exif}}),
          with_profile(with_exif(jpeg_file(64, 48, 3, {200, 100, 50, 0}), exif), p3),
          with_profile(jpeg_file(64, 48, 3, {200, 100, 50, 0}, true), p3),
          with_profile(jpeg_file(64, 48, 4, {200, 100, 50, 9}), ink_profile()),
          webp_with(*lossless, p3, exif, 64, 48, 0x10),
          *lossless,
          *lossy};
}

TEST(Photo, file_cut_short_anywhere_is_bad_input) {
  for (const Bytes& file : whole_files()) {
    ASSERT_TRUE(photo_in(file).ok()) << to_string(photo_in(file).status());
    for (std::size_t part = 0; part < 20; ++part) {
      const auto end = file.begin() + static_cast<std::ptrdiff_t>(file.size() * part / 20);
      const Status status = photo_in(Bytes(file.begin(), end)).status();
      EXPECT_EQ(status.code, StatusCode::bad_input) << part;
      EXPECT_EQ(status.where.file, "a.file");
      EXPECT_FALSE(status.message.empty());
    }
  }
}

TEST(Photo, damage_anywhere_is_an_image_or_an_honest_error) {
  std::mt19937 random(7);
  for (const Bytes& file : whole_files()) {
    for (int turn = 0; turn < 300; ++turn) {
      Bytes damaged = file;
      for (int i = 0; i <= turn % 3; ++i) {
        damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
      }
      const Result<Image> image = photo_in(damaged);
      if (image) {
        EXPECT_EQ(image->bytes.size(),
                  image->row_bytes() * static_cast<std::size_t>(image->height));
      } else {
        EXPECT_TRUE(image.status().code == StatusCode::bad_input ||
                    image.status().code == StatusCode::limit)
            << to_string(image.status());
      }
    }
  }
}

TEST(Photo, files_of_other_kinds_are_named) {
  const auto message = [](std::string_view text) {
    return to_string(photo_in(Bytes(text.begin(), text.end())).status());
  };
  const std::string expected = "; use a PNG, a JPEG or a WebP";
  EXPECT_EQ(message(""), "a.file: is an empty file" + expected);
  EXPECT_EQ(message("GIF89a......"), "a.file: is a GIF picture" + expected);
  EXPECT_EQ(message({"\0\0\0\x18"
                     "ftypheic",
                     12}),
            "a.file: is a HEIC or AVIF picture" + expected);
  EXPECT_EQ(message("<svg/>"), "a.file: is a drawing or other XML" + expected);
  EXPECT_EQ(message("hello"), "a.file: is not a picture" + expected);
  EXPECT_EQ(message({"II*\0", 4}), "a.file: is a TIFF or raw file" + expected);
}

TEST(Photo, animation_is_refused) {
  Context context;
  const auto webp = encode_webp(context, gradient(8, 8, PixelFormat::rgb8), {.lossless = true});
  ASSERT_TRUE(webp.ok());
  EXPECT_EQ(to_string(photo_in(webp_with(*webp, {}, {}, 8, 8, 0x02)).status()),
            "a.file: an animated WebP; use a still picture");
}

TEST(Photo, limits_are_checked_at_the_header) {
  for (const Bytes& file : whole_files()) {
    Context narrow;
    narrow.limits.image_side = 63;
    const Status side = codecs::read_photo(narrow, file, "a.file").status();
    EXPECT_EQ(to_string(side),
              "a.file: an image of 64 × 48 pixels; the limit is 63 pixels on a side");
    EXPECT_EQ(side.limit, "image-side");
    Context few;
    few.limits.texels = 64 * 48 - 1;
    EXPECT_EQ(codecs::read_photo(few, file, "a.file").status().limit, "texels");
  }
}

TEST(Photo, memory_beyond_the_budget_is_refused_and_none_is_kept) {
  for (const Bytes& file : whole_files()) {
    std::size_t refused = 0;
    for (std::size_t bytes = 1000;; bytes += bytes / 4) {
      Context context{.budget = Budget(bytes)};
      const Result<Image> image = codecs::read_photo(context, file, "a.file");
      EXPECT_EQ(context.budget.used(), 0u);
      if (image) break;
      EXPECT_EQ(image.status().limit, "memory") << to_string(image.status());
      ++refused;
    }
    EXPECT_GT(refused, 5u);
  }
}

TEST(Photo, cancelled_work_ends) {
  for (const Bytes& file : whole_files()) {
    Context context;
    context.cancel = true;
    EXPECT_EQ(codecs::read_photo(context, file, "a.file").status().code, StatusCode::cancelled);
  }
}

TEST(Photo, threads_make_the_same_bytes) {
  const Image image = gradient(700, 300, PixelFormat::rgb16);
  Bytes rows;
  for (std::size_t y = 0; y < 300; ++y) {
    rows.push_back(0);
    const std::uint8_t* row = &image.bytes[y * image.row_bytes()];
    rows.insert(rows.end(), row, row + image.row_bytes());
  }
  const Bytes png = png_of(700, 300, 16, 2, rows, {{"iCCP", png_profile(display_p3_profile())}});
  const Result<Image> alone = photo_in(png);
  ThreadPool executor(4);
  Context context{.executor = &executor};
  const Result<Image> together = codecs::read_photo(context, png, "a.file");
  ASSERT_TRUE(alone.ok() && together.ok());
  EXPECT_EQ(alone->bytes, together->bytes);
}

}  // namespace
}  // namespace sfumato
