#include <gtest/gtest.h>

#include <cmath>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

Picture flat_picture(float shade) {
  return make_picture(make_layer(jittered_grid({{0, 0}, {8, 8}}, 3, 1), [=](int, Vec2) {
    return Rgb{shade, shade, shade};
  }));
}

/// Returns a ramp from `low` at the left border to `high` at the right one, in code values.
Picture ramp_picture(float low, float high) {
  return make_picture(make_layer(jittered_grid({{0, 0}, {8, 8}}, 3, 1), [=](int, Vec2 p) {
    const float shade = (low + (high - low) * static_cast<float>(p.x / 8)) / 255;
    return Rgb{shade, shade, shade};
  }));
}

TEST(RasterOutput, dither_keeps_the_mean) {
  RasterOptions options = image_size(256, 128, PixelFormat::rgb8);
  options.dither = true;
  for (const float slope : {2.0f, 8.0f, 60.0f}) {
    const Image image = rasterized(ramp_picture(30, 30 + slope), options);
    for (int x0 = 0; x0 < 256; x0 += 16) {
      double sum = 0, expected = 0;
      for (int x = x0; x < x0 + 16; ++x) {
        const double exact = 30 + slope * (x + 0.5) / 256;
        for (int y = 0; y < 128; ++y) {
          const int pixel = channel(image, x, y, 1);
          EXPECT_NEAR(pixel, exact, 1.001) << x;
          sum += pixel;
        }
        expected += 128 * exact;
      }
      EXPECT_NEAR(sum / (16 * 128), expected / (16 * 128), 0.02) << slope << " at " << x0;
    }
  }
}

/// A difference of the last bit is not a slope, and 127.5 everywhere is a normal colour.
TEST(RasterOutput, dither_leaves_even_areas_even) {
  RasterOptions options = image_size(70, 70, PixelFormat::rgb8);
  for (float value : {10.0f, 10.25f, 99.5f, 127.5f, 200.77f}) {
    options.dither = false;
    const Image plain = rasterized(flat_picture(value / 255), options);
    options.dither = true;
    EXPECT_EQ(rasterized(flat_picture(value / 255), options).bytes, plain.bytes) << value;
  }
}

/// Blue noise: in a gentle slope, hardly any two neighbours are both above or both below the mean.
TEST(RasterOutput, dither_has_no_grain_and_no_pattern) {
  RasterOptions options = image_size(256, 128, PixelFormat::rgb8);
  options.dither = true;
  const Image image = rasterized(ramp_picture(30.3f, 30.7f), options);
  const auto is_up = [&](int x, int y) { return channel(image, x, y, 0) > 30; };
  const auto share_alike = [&](int dx, int dy) {
    int alike = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 128; ++x) alike += is_up(x, y) == is_up(x + dx, y + dy);
    return alike / (64.0 * 128);
  };
  EXPECT_LT(share_alike(1, 0), 0.46);
  EXPECT_LT(share_alike(0, 1), 0.46);
  for (int d : {8, 16, 32}) {
    EXPECT_NEAR(share_alike(d, 0), 0.5, 0.06) << d;
    EXPECT_NEAR(share_alike(0, d), 0.5, 0.06) << d;
  }
}

TEST(RasterOutput, dither_leaves_whole_code_values_alone) {
  RasterOptions options = image_size(16, 16, PixelFormat::rgb8);
  options.dither = true;
  for (int code = 0; code <= 255; ++code) {
    const Image image = rasterized(flat_picture(static_cast<float>(code) / 255), options);
    for (int i = 0; i < 16 * 16; ++i) ASSERT_EQ(channel(image, i % 16, i / 16, 0), code);
  }
}

TEST(RasterOutput, dither_does_not_touch_16_bits) {
  RasterOptions options = image_size(16, 16, PixelFormat::rgb16);
  const Image plain = rasterized(flat_picture(0.3f), options);
  options.dither = true;
  EXPECT_EQ(rasterized(flat_picture(0.3f), options).bytes, plain.bytes);
}

TEST(RasterOutput, every_code_value_of_16_bits_comes_out_as_it_is) {
  for (int code = 0; code <= 65535; code += 257 * 3 + 1) {
    const Image image =
        rasterized(flat_picture(static_cast<float>(code) / 65535), image_size(2, 2));
    EXPECT_EQ(channel(image, 1, 1, 2), code);
  }
}

TEST(RasterOutput, values_beyond_the_range_are_clamped) {
  const Image bright = rasterized(flat_picture(1.7f), image_size(5, 5, PixelFormat::rgb8));
  const Image dark = rasterized(flat_picture(-0.4f), image_size(5, 5, PixelFormat::rgb8));
  EXPECT_EQ(channel(bright, 2, 2, 0), 255);
  EXPECT_EQ(channel(dark, 2, 2, 0), 0);
}

/// Returns the four quarters of an image twice as large as the picture, which is in the upper left
/// quarter.
Image with_margin(const Picture& picture, RasterOptions options) {
  options.viewport = Box{{0, 0}, {16, 16}};
  return rasterized(picture, options);
}

TEST(RasterOutput, outside_of_the_picture_is_the_background) {
  Picture picture = flat_picture(0.2f);
  const auto outside = [&](PixelFormat format, std::optional<Rgb> background, int c) {
    RasterOptions options = image_size(32, 32, format);
    options.background = background;
    return channel(with_margin(picture, options), 20, 7, c);
  };
  EXPECT_EQ(outside(PixelFormat::rgb8, {}, 0), 255);
  EXPECT_EQ(outside(PixelFormat::rgba8, {}, 0), 0);
  EXPECT_EQ(outside(PixelFormat::rgba8, {}, 3), 0);
  EXPECT_EQ(outside(PixelFormat::rgba16, {}, 3), 0);
  EXPECT_EQ(outside(PixelFormat::rgb8, Rgb{0, 0.4f, 0}, 1), 102);
  picture.background = Rgb{0.6f, 0, 0};
  EXPECT_EQ(outside(PixelFormat::rgb8, {}, 0), 153);
  EXPECT_EQ(outside(PixelFormat::rgb8, Rgb{0, 0, 0}, 0), 0);
  EXPECT_EQ(outside(PixelFormat::rgba8, {}, 0), 153);
  EXPECT_EQ(outside(PixelFormat::rgba8, {}, 3), 255);
}

TEST(RasterOutput, inside_of_the_picture_is_opaque) {
  const Image image = with_margin(flat_picture(0.2f), image_size(32, 32, PixelFormat::rgba16));
  for (int i = 0; i < 32 * 32; ++i) {
    const int x = i % 32, y = i / 32;
    EXPECT_EQ(channel(image, x, y, 3), x < 16 && y < 16 ? 65535 : 0);
  }
}

TEST(RasterOutput, a_picture_without_layers_is_background) {
  Picture picture;
  picture.viewport = {{0, 0}, {1, 1}};
  const Image image = rasterized(picture, image_size(3, 300, PixelFormat::rgb8));
  for (std::uint8_t byte : image.bytes) EXPECT_EQ(byte, 255);
}

TEST(RasterOutput, later_instances_lie_on_earlier_ones) {
  Picture picture = flat_picture(0.2f);
  picture.layers.push_back(flat_picture(0.8f).layers[0]);
  picture.stack = {PatchInstance{0, {}}, PatchInstance{1, {0.25, 0, 0, 0.25, 2, 4}}};
  const Image image = rasterized(picture, image_size(32, 32, PixelFormat::rgb8));
  for (int i = 0; i < 32 * 32; ++i) {
    const int x = i % 32, y = i / 32;
    const bool upper = x >= 8 && x < 16 && y >= 16 && y < 24;
    EXPECT_EQ(channel(image, x, y, 0), upper ? 204 : 51);
  }
}

TEST(RasterOutput, pixels_need_not_be_square) {
  const RegionMesh mesh = cut_box({{0, 0}, {8, 8}}, {4, 8}, {4, 0});
  const Picture picture = make_picture(make_layer(mesh, [](int region, Vec2) {
    return region ? Rgb{1, 1, 1} : Rgb{};
  }));
  const Image image = rasterized(picture, image_size(10, 3, PixelFormat::rgb8));
  for (int i = 0; i < 30; ++i) EXPECT_EQ(channel(image, i % 10, i / 10, 0), i % 10 < 5 ? 0 : 255);
}

TEST(RasterOutput, the_overlay_draws_edges_and_nothing_else) {
  const RegionMesh mesh = cut_box({{0, 0}, {64, 64}}, {32.5, 64}, {32.5, 0});
  const Picture picture = make_picture(make_layer(mesh, [](int, Vec2) { return Rgb{1, 1, 1}; }));
  RasterOptions options = image_size(64, 64, PixelFormat::rgb8);
  options.mesh_overlay = true;
  const Image image = rasterized(picture, options);
  EXPECT_EQ(channel(image, 32, 20, 0), 255);  // the curve is orange
  EXPECT_LT(channel(image, 32, 20, 2), 40);
  EXPECT_EQ(channel(image, 24, 40, 2), 255);  // inside a triangle nothing changes
  int inked = 0;
  for (int x = 2; x < 31; ++x) inked += channel(image, x, 20, 2) < 250;
  EXPECT_GE(inked, 1);  // the diagonal of the left half
  EXPECT_LE(inked, 4);
}

}  // namespace
}  // namespace sfumato::test
