#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "raster/pictures.hpp"
#include "raster/support.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::test {
namespace {

Rgb steep_wave(int region, Vec2 p) {
  const auto wave = [&](double a, double b) {
    return static_cast<float>(0.5 + 0.5 * std::sin(a * p.x + b * p.y + region));
  };
  return {wave(3.1, 1.2), wave(-1.7, 2.3), wave(0.5, -4)};
}

Picture wavy_picture() {
  return make_picture(make_layer(
      jittered_grid({{0, 0}, {6, 5}}, 30, 17, [](int i, int j) { return i * j % 7; }), steep_wave));
}

/// Returns soft layers, groups and every blend mode.
Picture composited_picture(InterpolationSpace space) {
  const RegionMesh mesh =
      jittered_grid({{0, 0}, {6, 5}}, 12, 5, [](int i, int j) { return i * j % 5; });
  PatchLayer soft = make_layer(mesh, steep_wave);
  set_opacity(
      mesh, [](int region, Vec2 p) { return steep_wave(region + 1, p).g; }, &soft);
  Picture picture = wavy_picture();
  picture.interpolation = space;
  picture.layers.push_back(soft);
  for (int mode = 0; mode <= static_cast<int>(BlendMode::luminosity); ++mode) {
    const double angle = 0.4 * mode, x = mode % 4 * 1.4, y = mode / 4 * 1.2;
    const Affine turned{0.5 * std::cos(angle),
                        0.5 * std::sin(angle),
                        -0.4 * std::sin(angle),
                        0.4 * std::cos(angle),
                        x,
                        y};
    const BlendMode blend = static_cast<BlendMode>(mode);
    if (mode % 3 == 0) picture.stack.push_back(GroupBegin{0.8f, blend});
    picture.stack.push_back(PatchInstance{1, turned, 0.7f, blend});
    picture.stack.push_back(PatchInstance{0, {-0.1, 0, 0, 0.1, x + 1, y}});
    if (mode % 3 == 0) picture.stack.push_back(GroupEnd{});
  }
  return picture;
}

constexpr InterpolationSpace kSpaces[] = {InterpolationSpace::srgb, InterpolationSpace::linear,
                                          InterpolationSpace::oklab};

TEST(RasterDeterminism, compositing_gives_the_same_bytes_for_any_number_of_threads) {
  const Picture picture = composited_picture(InterpolationSpace::srgb);
  const RasterOptions options = image_size(700, 500, PixelFormat::rgba16);
  const Image alone = rasterized(picture, options);
  for (int threads : {2, 5}) {
    ThreadPool executor(threads);
    Context context;
    context.executor = &executor;
    const Result<Image> image = rasterize(context, picture, options);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->bytes, alone.bytes) << threads << " threads";
  }
}

TEST(RasterDeterminism, compositing_gives_the_same_bytes_for_any_instruction_set) {
  for (InterpolationSpace space : kSpaces) {
    const Picture picture = composited_picture(space);
    expect_same_for_every_instruction_set(picture, image_size(413, 301, PixelFormat::rgba16));
  }
}

TEST(RasterDeterminism, a_small_viewport_of_a_composition_is_the_crop_of_a_large_image) {
  const Picture picture = composited_picture(InterpolationSpace::srgb);
  const Image whole = rasterized(picture, image_size(600, 500));
  for (const auto& [x0, y0, width, height] : {std::array{0, 0, 100, 90}, {123, 77, 260, 130}}) {
    RasterOptions options = image_size(width, height);
    options.viewport = Box{{x0 / 100.0, y0 / 100.0}, {(x0 + width) / 100.0, (y0 + height) / 100.0}};
    const Image part = rasterized(picture, options);
    double worst = 0, sum = 0;
    for (int i = 0; i < width * height * 3; ++i) {
      const int x = i / 3 % width, y = i / 3 / width;
      const double difference =
          std::fabs(code_value(part, x, y, i % 3) - code_value(whole, x0 + x, y0 + y, i % 3));
      worst = std::max(worst, difference);
      sum += difference;
    }
    // Steep modes magnify the last bits.
    EXPECT_LT(worst, 1);
    EXPECT_LT(sum / (width * height * 3), 1e-3);
  }
}

TEST(RasterDeterminism, any_number_of_threads_gives_the_same_bytes) {
  const Picture picture = wavy_picture();
  RasterOptions options = image_size(700, 500, PixelFormat::rgb16);
  options.mesh_overlay = true;
  const Image alone = rasterized(picture, options);
  for (int threads : {1, 2, 3, 8}) {
    ThreadPool executor(threads);
    Context context;
    context.executor = &executor;
    const Result<Image> image = rasterize(context, picture, options);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->bytes, alone.bytes) << threads << " threads";
  }
}

TEST(RasterDeterminism, an_image_that_is_made_in_bands_is_the_same_for_any_number_of_threads) {
  const Picture picture = wavy_picture();
  const RasterOptions options = image_size(1500, 1601, PixelFormat::rgba16);
  const Image alone = rasterized(picture, options);
  ASSERT_EQ(alone.bytes.size(), std::size_t{8} * 1500 * 1601);
  for (int threads : {2, 7}) {
    ThreadPool executor(threads);
    Context context;
    context.executor = &executor;
    const Result<Image> image = rasterize(context, picture, options);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->bytes, alone.bytes) << threads << " threads";
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(RasterDeterminism, any_instruction_set_gives_the_same_bytes) {
  const Picture picture = wavy_picture();
  for (PixelFormat format :
       {PixelFormat::rgb8, PixelFormat::rgba8, PixelFormat::rgb16, PixelFormat::rgba16}) {
    RasterOptions options = image_size(413, 301, format);
    options.dither = true;
    std::vector<std::uint8_t> first;
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      Context context;
      context.simd = level;
      const Result<Image> image = rasterize(context, picture, options);
      ASSERT_TRUE(image.ok());
      if (first.empty()) first = image->bytes;
      EXPECT_EQ(image->bytes, first) << static_cast<int>(level);
    }
  }
}

TEST(RasterDeterminism, a_small_viewport_is_the_crop_of_a_large_image) {
  const Picture picture = wavy_picture();
  const Image whole = rasterized(picture, image_size(600, 500));
  for (const auto& [x0, y0, width, height] :
       {std::array{0, 0, 100, 90}, {123, 77, 260, 130}, {599, 499, 1, 1}, {37, 250, 563, 3}}) {
    RasterOptions options = image_size(width, height);
    options.viewport = Box{{x0 / 100.0, y0 / 100.0}, {(x0 + width) / 100.0, (y0 + height) / 100.0}};
    const Image part = rasterized(picture, options);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(channel(part, x, y, c), channel(whole, x0 + x, y0 + y, c), 2);
      }
    }
  }
}

TEST(RasterDeterminism, the_order_of_triangles_changes_nothing_visible) {
  const RegionMesh mesh =
      jittered_grid({{0, 0}, {6, 5}}, 20, 17, [](int i, int j) { return i * j % 7; });
  RegionMesh reversed = mesh;
  std::reverse(reversed.triangle.begin(), reversed.triangle.end());
  std::reverse(reversed.region.begin(), reversed.region.end());
  for (Corners& corner : reversed.triangle) corner = {corner[1], corner[2], corner[0]};
  const Image a = rasterized(make_picture(make_layer(mesh, steep_wave)), image_size(150, 100));
  const Image b = rasterized(make_picture(make_layer(reversed, steep_wave)), image_size(150, 100));
  for (int i = 0; i < 150 * 100 * 3; ++i)
    ASSERT_NEAR(channel(a, i / 3 % 150, i / 450, i % 3), channel(b, i / 3 % 150, i / 450, i % 3),
                2);
}

}  // namespace
}  // namespace sfumato::test
