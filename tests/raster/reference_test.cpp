#include "raster/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "raster/coverage/clip.hpp"
#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

/// Returns a smooth colour between -0.1 and 1.1, different in each region.
Rgb wave_out_of_range(int region, Vec2 p) {
  const double phase = 2.1 * region;
  const auto wave = [&](double a, double b) {
    return static_cast<float>(0.5 + 0.6 * std::sin(a * p.x + b * p.y + phase));
  };
  return {wave(0.31, 0.12), wave(-0.17, 0.23), wave(0.05, -0.4)};
}

struct Disagreement {
  double worst = 0;  ///< code values of 255
  int coverage = 0;  ///< pixels that only one of the two paints
};

Disagreement compare(const Picture& picture, const Box& viewport, int width, int height) {
  RasterOptions options = image_size(width, height, PixelFormat::rgba16);
  options.viewport = viewport;
  const Image image = rasterized(picture, options);
  const auto triangles = reference_triangles(picture, viewport, width, height);
  Disagreement result;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const ReferencePixel expected = reference_pixel(triangles, x, y);
      if (expected.covered != (channel(image, x, y, 3) > 0)) ++result.coverage;
      if (!expected.covered) continue;
      for (int c = 0; c < 3; ++c) {
        const double miss = std::fabs(code_value(image, x, y, c) - 255 * expected.color[c]);
        result.worst = std::max(result.worst, miss);
      }
    }
  }
  return result;
}

TEST(RasterReference, random_pictures_agree_at_any_scale) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * (random() / 4294967296.0);
    };
    const int cells = 2 + static_cast<int>(random() % 12);
    const RegionMesh mesh = jittered_grid({{0, 0}, {20, 15}}, cells, seed, [&](int i, int j) {
      return (i * 3 + j * 5 + static_cast<int>(seed)) / 4 % 3;
    });
    Picture picture = make_picture(make_layer(mesh, wave_out_of_range));
    picture.layers[0].order = static_cast<PatchOrder>(seed % 3);
    const double side = std::exp(uniform(-4, 4));
    const Vec2 corner{uniform(-0.3 * side, 20 - 0.3 * side), uniform(-0.3 * side, 15)};
    const Box viewport{corner, {corner.x + side, corner.y + side * uniform(0.5, 2)}};
    const Disagreement result = compare(picture, viewport, 70, 66);
    EXPECT_LT(result.worst, kAllowed) << "seed " << seed;
    EXPECT_EQ(result.coverage, 0) << "seed " << seed;
  }
}

TEST(RasterReference, many_triangles_in_a_pixel_agree) {
  const RegionMesh mesh =
      jittered_grid({{0, 0}, {20, 15}}, 40, 3, [](int i, int j) { return (i / 7 + j / 5) % 3; });
  const Picture picture = make_picture(make_layer(mesh, wave_out_of_range));
  for (int side : {1, 2, 5, 9}) {
    const Disagreement result = compare(picture, picture.viewport, side, side);
    EXPECT_LT(result.worst, kAllowed);
    EXPECT_EQ(result.coverage, 0);
  }
}

TEST(RasterReference, a_turned_and_scaled_instance_agrees) {
  const RegionMesh mesh =
      jittered_grid({{0, 0}, {20, 15}}, 8, 9, [](int i, int j) { return i * j % 3; });
  Picture picture = make_picture(make_layer(mesh, wave_out_of_range));
  std::get<PatchInstance>(picture.stack[0]).artboard_from_layer = {0.8, 0.6, -0.6, 0.8, 9, -2};
  const Disagreement result = compare(picture, {{0, 0}, {25, 25}}, 80, 80);
  EXPECT_LT(result.worst, kAllowed);
  EXPECT_EQ(result.coverage, 0);
}

TEST(RasterReference, a_mirrored_instance_is_the_mirrored_image) {
  const RegionMesh mesh =
      jittered_grid({{0, 0}, {20, 15}}, 8, 9, [](int i, int j) { return i * j % 3; });
  Picture picture = make_picture(make_layer(mesh, wave_out_of_range));
  const Image plain = rasterized(picture, image_size(61, 40));
  std::get<PatchInstance>(picture.stack[0]).artboard_from_layer = {-1, 0, 0, 1, 20, 0};
  const Image mirrored = rasterized(picture, image_size(61, 40));
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 61; ++x) {
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(code_value(plain, x, y, c), code_value(mirrored, 60 - x, y, c), 0.02);
    }
  }
}

TEST(RasterReference, areas_of_all_triangles_in_a_pixel_sum_to_one) {
  const RegionMesh mesh = jittered_grid({{-3, -3}, {11, 11}}, 17, 21);
  for (double scale : {0.4, 1.0, 3.7, 250.0}) {
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        double sum = 0;
        for (const Corners& corner : mesh.triangle) {
          const raster::ClipTriangle clip =
              raster::clip_triangle(mesh.vertex[corner[0]] * scale, mesh.vertex[corner[1]] * scale,
                                    mesh.vertex[corner[2]] * scale);
          const raster::Coverage part = raster::pixel_coverage(clip, x, y);
          EXPECT_GE(part.area, 0);
          sum += part.area;
        }
        const bool inside = scale >= 1 || (x < 3 && y < 3);
        if (inside) {
          EXPECT_NEAR(sum, 1, 1e-11);
        }
      }
    }
  }
}

TEST(RasterReference, the_part_of_a_triangle_in_a_pixel_has_the_polygons_centroid) {
  const raster::ClipTriangle half = raster::clip_triangle({0, 0}, {1, 0}, {0, 1});
  const raster::Coverage part = raster::pixel_coverage(half, 0, 0);
  EXPECT_NEAR(part.area, 0.5, 1e-15);
  EXPECT_NEAR(part.centroid.x, 1.0 / 3, 1e-15);
  EXPECT_NEAR(part.centroid.y, 1.0 / 3, 1e-15);
  const raster::ClipTriangle wide = raster::clip_triangle({-100, -7.75}, {100, -7.75}, {0, 300});
  const raster::Coverage strip = raster::pixel_coverage(wide, 2, -8);
  EXPECT_NEAR(strip.area, 0.75, 1e-12);
  EXPECT_NEAR(strip.centroid.x, 0.5, 1e-12);
  EXPECT_NEAR(strip.centroid.y, 0.625, 1e-12);
}

}  // namespace
}  // namespace sfumato::test
