// Photos whose colours are not in sRGB.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "codecs/photo/photo.hpp"
#include "formats/image_files.hpp"
#include "formats/photo_files.hpp"
#include "formats/photo_support.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato {
namespace {

using namespace test;

using Color = std::array<int, 3>;

/// Returns an 8-bit PNG of one pixel.
Bytes pixel_png(const Color& color, const std::vector<PngChunk>& chunks) {
  Bytes row{0};
  for (const int channel : color) row.push_back(static_cast<std::uint8_t>(channel));
  return png_of(1, 1, 8, 2, row, chunks);
}

void expect_color(const Result<Image>& image, const Color& expected, int tolerance = 1) {
  ASSERT_TRUE(image.ok()) << to_string(image.status());
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(image->bytes[c], expected[c], tolerance) << "channel " << c;
  }
}

double light_of(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

int srgb_code_of(double light) {
  const double code = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * std::clamp(code, 0.0, 1.0)));
}

/// Converts by the matrix between the two spaces, both with white D65.
Color srgb_of_p3(const Color& color) {
  const double r = light_of(color[0] / 255.0), g = light_of(color[1] / 255.0),
               b = light_of(color[2] / 255.0);
  return {srgb_code_of(1.2249401 * r - 0.2249402 * g), srgb_code_of(-0.0420569 * r + 1.0420571 * g),
          srgb_code_of(-0.0196376 * r - 0.0786361 * g + 1.0982735 * b)};
}

Bytes four_numbers(std::initializer_list<std::uint32_t> numbers) {
  Bytes bytes;
  for (const std::uint32_t number : numbers) append_number(number, bytes);
  return bytes;
}

const std::vector<Color> kColors{{200, 100, 50}, {10, 180, 90},   {90, 90, 90},
                                 {0, 0, 0},      {255, 255, 255}, {255, 10, 10}};

TEST(PhotoColors, display_p3_becomes_srgb) {
  const Bytes profile = display_p3_profile();
  Context context;
  for (const Color& color : kColors) {
    const Color expected = srgb_of_p3(color);
    expect_color(photo_in(pixel_png(color, {{"iCCP", png_profile(profile)}})), expected);
    const std::array<std::uint8_t, 4> bytes{std::uint8_t(color[0]), std::uint8_t(color[1]),
                                            std::uint8_t(color[2]), 0};
    // YCbCr in the file is rounded.
    expect_color(photo_in(with_profile(jpeg_file(8, 8, 3, bytes), profile)), expected, 3);
    expect_color(photo_in(with_profile(jpeg_file(8, 8, 3, bytes), profile, 100)), expected, 3);
    const auto webp = encode_webp(
        context, {1, 1, PixelFormat::rgb8, {bytes[0], bytes[1], bytes[2]}}, {.lossless = true});
    ASSERT_TRUE(webp.ok());
    expect_color(photo_in(webp_with(*webp, profile, {}, 1, 1)), expected);
  }
}

TEST(PhotoColors, sixteen_bits_are_converted_as_such_beside_alpha) {
  const PngChunk profile{"iCCP", png_profile(display_p3_profile())};
  const Result<Image> image =
      photo_in(png_of(1, 1, 16, 6, {0, 200, 200, 100, 100, 50, 50, 0x12, 0x34}, {profile}));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->format, PixelFormat::rgba16);
  std::array<std::uint16_t, 4> values{};
  std::memcpy(values.data(), image->bytes.data(), 8);
  const Color expected = srgb_of_p3({200, 100, 50});
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(values[c] / 257.0, expected[c], 0.6);
  EXPECT_EQ(values[3], 0x1234);
}

TEST(PhotoColors, channels_that_a_profile_swaps_are_swapped_back) {
  const PngChunk profile{"iCCP", png_profile(swapped_profile())};
  expect_color(photo_in(pixel_png({10, 20, 200}, {profile})), {200, 20, 10});
  expect_color(photo_in(png_of(1, 1, 8, 3, {0, 0}, {profile, {"PLTE", {10, 20, 200}}})),
               {200, 20, 10});
}

TEST(PhotoColors, gray_of_linear_light_becomes_srgb) {
  const Bytes profile = gray_profile(1.0);
  const int expected = srgb_code_of(128 / 255.0);
  expect_color(photo_in(png_of(1, 1, 8, 0, {0, 128}, {{"iCCP", png_profile(profile)}})),
               {expected, expected, expected});
  const Result<Image> with_alpha =
      photo_in(png_of(1, 1, 8, 4, {0, 128, 77}, {{"iCCP", png_profile(profile)}}));
  expect_color(with_alpha, {expected, expected, expected});
  EXPECT_EQ(with_alpha->bytes[3], 77);
  expect_color(photo_in(with_profile(jpeg_file(8, 8, 1, {128, 0, 0, 0}), profile)),
               {expected, expected, expected});
}

TEST(PhotoColors, gray_with_a_profile_of_rgb_is_converted_by_it) {
  const PngChunk profile{"iCCP", png_profile(display_p3_profile())};
  expect_color(photo_in(png_of(1, 1, 8, 0, {0, 128}, {profile})), {128, 128, 128});
}

TEST(PhotoColors, inks_with_a_profile_are_converted_by_it) {
  const Bytes profile = ink_profile();
  // Adobe's bytes: 255 is no ink. Full cyan gives L* of 100 · 2/3.
  const auto gray_of = [](double lightness) {
    return srgb_code_of(std::pow((lightness + 16) / 116, 3));
  };
  const int third = gray_of(200 / 3.0), dark = gray_of(50);
  expect_color(photo_in(with_profile(jpeg_file(8, 8, 4, {0, 255, 255, 255}), profile)),
               {third, third, third}, 2);
  expect_color(photo_in(with_profile(jpeg_file(8, 8, 4, {255, 255, 255, 128}), profile)),
               {dark, dark, dark}, 2);
  expect_color(photo_in(with_profile(jpeg_file(8, 8, 4, {255, 255, 255, 255}), profile)),
               {255, 255, 255});
}

TEST(PhotoColors, inks_without_a_profile_are_converted_by_the_formula) {
  const Result<Image> image = photo_in(jpeg_file(8, 8, 4, {0, 255, 255, 255}));
  expect_color(image, {0, 255, 255});
  EXPECT_EQ(image->format, PixelFormat::rgb8);
}

TEST(PhotoColors, profile_of_srgb_changes_no_byte) {
  Bytes rows{0};
  for (int i = 0; i < 256; ++i) {
    for (const int channel : {i, 255 - i, i * 7 % 256}) {
      rows.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  const Result<Image> image =
      photo_in(png_of(256, 1, 8, 2, rows, {{"iCCP", png_profile(srgb_profile())}}));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->bytes, Bytes(rows.begin() + 1, rows.end()));
}

TEST(PhotoColors, profile_of_other_channels_is_ignored_with_a_warning) {
  const auto expect_warning = [](const Bytes& file, const std::string& reason) {
    Warnings warnings;
    const Result<Image> image = photo_in(file, &warnings);
    ASSERT_TRUE(image.ok());
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(to_string(warnings[0]), "a.file: the colour profile is ignored: " + reason);
  };
  const PngChunk inks{"iCCP", png_profile(ink_profile())};
  const PngChunk gray{"iCCP", png_profile(gray_profile(1))};
  expect_warning(pixel_png({1, 2, 3}, {inks}), "it is not one of RGB colours");
  expect_warning(pixel_png({1, 2, 3}, {gray}), "it is not one of RGB colours");
  expect_warning(png_of(1, 1, 8, 0, {0, 128}, {inks}), "it is not one of gray colours");
  expect_warning(with_profile(jpeg_file(8, 8, 4, {0, 0, 0, 0}), srgb_profile()),
                 "it is not one of CMYK colours");
}

TEST(PhotoColors, profile_cut_short_is_ignored_with_a_warning_or_has_lost_nothing) {
  const Bytes whole = swapped_profile();
  std::size_t ignored = 0;
  for (std::size_t part = 1; part < 20; ++part) {
    const Bytes cut(whole.begin(),
                    whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * part / 20));
    const std::vector<Bytes> files{pixel_png({10, 20, 200}, {{"iCCP", png_profile(cut)}}),
                                   with_profile(jpeg_file(8, 8, 3, {10, 20, 200, 0}), cut)};
    for (const Bytes& file : files) {
      Warnings warnings;
      const Result<Image> image = photo_in(file, &warnings);
      if (warnings.empty()) {
        expect_color(image, {200, 20, 10}, 3);
        continue;
      }
      expect_color(image, {10, 20, 200}, 3);
      ++ignored;
      ASSERT_EQ(warnings.size(), 1u) << part;
      EXPECT_TRUE(warnings[0].message.starts_with("the colour profile is ignored: it "));
    }
  }
  EXPECT_GT(ignored, 30u);
}

TEST(PhotoColors, profile_with_a_part_missing_is_ignored_with_a_warning) {
  const Bytes profile = swapped_profile();
  Bytes data{'I', 'C', 'C', '_', 'P', 'R', 'O', 'F', 'I', 'L', 'E', 0, 1, 2};
  data.insert(data.end(), profile.begin(), profile.end());
  Warnings warnings;
  expect_color(photo_in(with_segment(jpeg_file(8, 8, 3, {10, 20, 200, 0}), 0xE2, data), &warnings),
               {10, 20, 200}, 3);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "the colour profile is ignored: it is damaged");
}

TEST(PhotoColors, profile_that_does_not_unpack_is_ignored_with_a_warning) {
  Warnings warnings;
  expect_color(photo_in(pixel_png({10, 20, 200}, {{"iCCP", {'n', 0, 0, 1, 2, 3, 4}}}), &warnings),
               {10, 20, 200});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "the colour profile is ignored: it is damaged");
}

TEST(PhotoColors, profiles_with_any_damage_make_pictures) {
  std::mt19937 random(3);
  const std::vector<Bytes> profiles{display_p3_profile(), ink_profile(), gray_profile(2)};
  const std::vector<int> channels{3, 4, 1};
  for (int turn = 0; turn < 600; ++turn) {
    const auto kind = static_cast<std::size_t>(turn % 3);
    Bytes profile = profiles[kind];
    for (int i = 0; i <= turn % 5; ++i) {
      // The largest part of a table of inks is colours.
      const std::size_t end =
          turn % 2 == 0 ? std::min<std::size_t>(600, profile.size()) : profile.size();
      profile[random() % end] = static_cast<std::uint8_t>(random());
    }
    const Result<Image> image =
        photo_in(with_profile(jpeg_file(8, 8, channels[kind], {10, 20, 200, 30}), profile));
    ASSERT_TRUE(image.ok()) << to_string(image.status());
    EXPECT_EQ(image->bytes.size(), 3u * 64);
  }
}

TEST(PhotoColors, gama_and_chrm_count_where_the_png_has_nothing_better) {
  const PngChunk linear{"gAMA", four_numbers({100'000})};
  const PngChunk screen{"gAMA", four_numbers({45'455})};
  const PngChunk p3{"cHRM",
                    four_numbers({31'270, 32'900, 68'000, 32'000, 26'500, 69'000, 15'000, 6'000})};
  const Color color{200, 100, 50}, p3_color = srgb_of_p3(color);
  const Color linear_color{srgb_code_of(200 / 255.0), srgb_code_of(100 / 255.0),
                           srgb_code_of(50 / 255.0)};
  expect_color(photo_in(pixel_png(color, {linear})), linear_color);
  expect_color(photo_in(pixel_png(color, {screen})), color, 0);
  expect_color(photo_in(pixel_png(color, {p3})), p3_color);
  expect_color(photo_in(pixel_png(color, {screen, p3})), p3_color);
  expect_color(photo_in(pixel_png(color, {{"sRGB", {0}}, linear, p3})), color, 0);
  expect_color(photo_in(pixel_png(color, {{"iCCP", png_profile(swapped_profile())}, linear})),
               {50, 100, 200});
  const int gray = srgb_code_of(128 / 255.0);
  expect_color(photo_in(png_of(1, 1, 8, 0, {0, 128}, {linear})), {gray, gray, gray});
}

TEST(PhotoColors, gama_stands_in_for_a_damaged_profile) {
  Warnings warnings;
  const PngChunk linear{"gAMA", four_numbers({100'000})};
  const int gray = srgb_code_of(128 / 255.0);
  expect_color(
      photo_in(pixel_png({128, 128, 128}, {linear, {"iCCP", png_profile({1, 2, 3})}}), &warnings),
      {gray, gray, gray});
  EXPECT_EQ(warnings.size(), 1u);
}

TEST(PhotoColors, numbers_that_are_no_colours_are_ignored_with_a_warning) {
  const PngChunk flat{"cHRM", four_numbers({31'270, 32'900, 1, 1, 1, 1, 1, 1})};
  Warnings warnings;
  expect_color(photo_in(pixel_png({10, 20, 200}, {flat}), &warnings), {10, 20, 200}, 0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "gAMA and cHRM are ignored: they cannot be used");
  for (const std::uint32_t gamma : {0u, 1u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
    EXPECT_TRUE(photo_in(pixel_png({10, 20, 200}, {{"gAMA", four_numbers({gamma})}})).ok())
        << gamma;
  }
}

}  // namespace
}  // namespace sfumato
