#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <variant>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

/// Returns the number of background pixels of `image`: alpha 0.
int holes(const Image& image) {
  int count = 0;
  for (int i = 0; i < image.width * image.height; ++i)
    count += channel(image, i % image.width, i / image.width, 3) == 0;
  return count;
}

TEST(RasterSeams, no_pixel_of_a_triangulated_viewport_is_left_out) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    // Some vertices are on whole and half pixels, the worst places for a rule about centres.
    RegionMesh mesh = jittered_grid({{0, 0}, {64, 64}}, 16, seed);
    if (seed % 2 == 0)
      for (Vec2& p : mesh.vertex) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
    Picture picture = make_picture(make_layer(mesh, [](int, Vec2) { return Rgb{1, 0, 1}; }));
    for (const int side : {64, 63, 640}) {
      RasterOptions options = image_size(side, side, PixelFormat::rgba8);
      options.antialias = false;
      EXPECT_EQ(holes(rasterized(picture, options)), 0) << "seed " << seed << " side " << side;
    }
  }
}

TEST(RasterSeams, every_centre_belongs_to_one_triangle_only) {
  // Each triangle alone in its picture: the painted pixels of all add up to the image.
  RegionMesh mesh = jittered_grid({{0, 0}, {32, 32}}, 6, 4);
  for (Vec2& p : mesh.vertex) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
  std::vector<int> painted(32 * 32, 0);
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    RegionMesh one{mesh.vertex, {mesh.triangle[t]}, {0}};
    const Picture picture = make_picture(make_layer(one, [](int, Vec2) { return Rgb{}; }));
    const Image image = rasterized(picture, image_size(32, 32, PixelFormat::rgba8));
    for (int i = 0; i < 32 * 32; ++i) painted[i] += channel(image, i % 32, i / 32, 3) != 0;
  }
  for (int count : painted) EXPECT_EQ(count, 1);
}

TEST(RasterSeams, slivers_leave_no_holes) {
  // A fan of needles around a far corner and one-unit-thin strips of nearly parallel edges.
  RegionMesh mesh;
  mesh.vertex = {{0, 0}, {100, 0}, {0, 100}};
  constexpr std::uint32_t kSlices = 500;
  for (std::uint32_t i = 0; i <= kSlices; ++i) mesh.vertex.push_back({100, 100.0 * i / kSlices});
  for (std::uint32_t i = 0; i < kSlices; ++i) mesh.add(0, 3 + i, 4 + i, 0);
  mesh.add(0, 3 + kSlices, 2, 0);
  const Picture picture = make_picture(make_layer(mesh, [](int, Vec2) { return Rgb{}; }));
  for (int side : {20, 100, 333, 1500})
    EXPECT_EQ(holes(rasterized(picture, image_size(side, side, PixelFormat::rgba8))), 0);
}

/// Returns a layer around its origin, with triangles finer than pixels and jumping colours, in the
/// middle of an image of two columns and two rows of tiles. A soft edge also needs the triangles
/// around a tile.
Picture fine_layer_at(Vec2 center) {
  const RegionMesh mesh = jittered_grid(
      {{-8, -8}, {8, 8}}, 40, 6, [](int column, int row) { return (column / 3 + row / 3) % 2; });
  PatchLayer layer = make_layer(mesh, [](int region, Vec2 p) {
    return region == 0 ? Rgb{0.2f, static_cast<float>(0.5 + 0.02 * p.x), 0.9f} : Rgb{0.9f, 0.6f, 0};
  });
  SoftEdge edge;
  edge.front = 0;
  edge.reach[0] = edge.reach[1] = {0, 3};
  layer.soft_edge.push_back(edge);
  Picture picture = make_picture(std::move(layer));
  picture.artboard = picture.viewport = {{0, 0}, {512, 128}};
  std::get<PatchInstance>(picture.stack.front()).artboard_from_layer = {1, 0,        0,
                                                                        1, center.x, center.y};
  return picture;
}

TEST(RasterSeams, tiles_show_nowhere_in_triangles_finer_than_pixels) {
  const RasterOptions options = image_size(512, 128);
  const Image across = rasterized(fine_layer_at({256, 64}), options);
  const Image inside = rasterized(fine_layer_at({128, 32}), options);
  for (int y = -10; y < 10; ++y) {
    for (int x = -10; x < 10; ++x) {
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(channel(across, 256 + x, 64 + y, c), channel(inside, 128 + x, 32 + y, c), 2)
            << x << ' ' << y;
    }
  }
}

TEST(RasterSeams, two_colours_give_only_mixtures_of_the_two) {
  const Rgb a{0.9f, 0.1f, 0.2f}, b{0.1f, 0.5f, 0.8f};
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const RegionMesh mesh = jittered_grid({{0, 0}, {1, 1}}, 14, seed,
                                          [](int i, int j) { return (i * 7 + j * 3) % 5 / 3; });
    const Picture picture =
        make_picture(make_layer(mesh, [&](int region, Vec2) { return region ? b : a; }));
    const Image image = rasterized(picture, image_size(90, 90));
    int mixtures = 0;
    for (int i = 0; i < 90 * 90; ++i) {
      const int x = i % 90, y = i / 90;
      const double share = (channel(image, x, y, 0) / 65535.0 - a.r) / (b.r - a.r);
      ASSERT_GE(share, -1e-4);
      ASSERT_LE(share, 1 + 1e-4);
      ASSERT_NEAR(channel(image, x, y, 1), 65535 * lerp(a.g, b.g, static_cast<float>(share)), 3);
      ASSERT_NEAR(channel(image, x, y, 2), 65535 * lerp(a.b, b.b, static_cast<float>(share)), 3);
      mixtures += share > 1e-3 && share < 1 - 1e-3;
    }
    EXPECT_GT(mixtures, 200);
  }
}

TEST(RasterSeams, pixels_away_from_curves_are_not_mixed) {
  const RegionMesh mesh = cut_box({{0, 0}, {32, 32}}, {9.3, 32}, {20.1, 0});
  const Picture picture = make_picture(make_layer(mesh, [](int region, Vec2) {
    return region ? Rgb{1, 1, 1} : Rgb{0, 0, 0};
  }));
  const Image image = rasterized(picture, image_size(32, 32, PixelFormat::rgb8));
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const double top_x = 20.1 - 10.8 * y / 32, bottom_x = 20.1 - 10.8 * (y + 1) / 32;
      if (x + 1 <= bottom_x) {
        EXPECT_EQ(channel(image, x, y, 0), 0);
      }
      if (x >= top_x) {
        EXPECT_EQ(channel(image, x, y, 0), 255);
      }
    }
  }
}

}  // namespace
}  // namespace sfumato::test
