#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

constexpr Box kUnitBox{{0, 0}, {1, 1}};

Rgb linear_ramp(Vec2 p) {
  return {static_cast<float>(0.1 + 0.8 * p.x), static_cast<float>(0.9 - 0.7 * p.y),
          static_cast<float>(0.2 + 0.3 * p.x + 0.4 * p.y)};
}

Rgb cubic_field(Vec2 p) {
  const double x = p.x, y = p.y;
  return {static_cast<float>(0.5 + 0.4 * x * x * x - 0.6 * x * y * y + 0.2 * y),
          static_cast<float>(0.3 + 0.5 * y * y * y + 0.3 * x * x * y - 0.2 * x * y),
          static_cast<float>(0.7 - 0.4 * x * x + 0.2 * x * y * (1 - y))};
}

/// Returns the largest difference to `field` at pixel centres, in code values of 255, ignoring
/// regions.
double worst_miss(const Image& image, const Box& viewport, Rgb (*field)(Vec2)) {
  double worst = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec2 p{viewport.min.x + viewport.width() * (x + 0.5) / image.width,
                   viewport.min.y + viewport.height() * (y + 0.5) / image.height};
      const Rgb value = field(p);
      const float expected[3] = {value.r, value.g, value.b};
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::fabs(code_value(image, x, y, c) - 255 * expected[c]));
    }
  }
  return worst;
}

TEST(RasterClosedForms, one_colour_is_exactly_constant_at_any_size_and_offset) {
  const float shades[] = {0, 1, 0.5f, 1 / 3.0f, 127.5f / 255, 200 / 255.0f, 0.123456f};
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {256, 64}, {257, 65}, {300, 200}}) {
    for (float shade : shades) {
      const RegionMesh mesh = jittered_grid(kUnitBox, 9, 5, [](int i, int j) { return i * j % 3; });
      const Rgb color{shade, 1 - shade, shade * shade};
      Picture picture = make_picture(make_layer(mesh, [&](int, Vec2) { return color; }));
      for (const Box& viewport :
           {kUnitBox, Box{{0.21, 0.33}, {0.57, 0.61}}, Box{{0.5, 0.5}, {0.500001, 0.500002}}}) {
        picture.viewport = viewport;
        for (PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgb16}) {
          const Image image = rasterized(picture, image_size(width, height, format));
          const float maximum = format == PixelFormat::rgb8 ? 255 : 65535;
          const float expected[3] = {color.r, color.g, color.b};
          for (int i = 0; i < width * height * 3; ++i) {
            const int c = i % 3, x = i / 3 % width, y = i / 3 / width;
            ASSERT_EQ(channel(image, x, y, c), static_cast<int>(expected[c] * maximum + 0.5f));
          }
        }
      }
    }
  }
}

TEST(RasterClosedForms, a_linear_ramp_is_exact_also_where_curves_pass) {
  for (PatchOrder order : {PatchOrder::linear, PatchOrder::quadratic, PatchOrder::cubic}) {
    const RegionMesh mesh = jittered_grid(kUnitBox, 12, 7, [](int i, int j) { return i * j % 4; });
    PatchLayer layer = make_layer(mesh, [](int, Vec2 p) { return linear_ramp(p); });
    layer.order = order;
    const Image image = rasterized(make_picture(layer), image_size(201, 133));
    EXPECT_LT(worst_miss(image, kUnitBox, linear_ramp), kAllowed);
  }
}

TEST(RasterClosedForms, ten_nodes_reproduce_a_cubic_anywhere) {
  const RegionMesh mesh = jittered_grid(kUnitBox, 4, 11);
  Picture picture = make_picture(make_layer(mesh, [](int, Vec2 p) { return cubic_field(p); }));
  for (const Box& viewport :
       {kUnitBox, Box{{0.4, 0.1}, {0.7, 0.4}}, Box{{0.3, 0.6}, {0.3001, 0.60005}}}) {
    picture.viewport = viewport;
    const Image image = rasterized(picture, image_size(97, 130));
    EXPECT_LT(worst_miss(image, viewport, cubic_field), kAllowed);
  }
}

TEST(RasterClosedForms, needles_reproduce_a_cubic) {
  RegionMesh mesh;
  mesh.vertex = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  constexpr int kSlices =
      200;  // fans around two corners: triangles up to 200 times as long as wide
  for (int i = 1; i < kSlices; ++i) mesh.vertex.push_back({1, static_cast<double>(i) / kSlices});
  for (int i = 1; i < kSlices; ++i) mesh.vertex.push_back({static_cast<double>(i) / kSlices, 1});
  for (std::uint32_t i = 0; i < kSlices; ++i) {
    const std::uint32_t from = i == 0 ? 1 : 3 + i, to = i + 1 == kSlices ? 2 : 4 + i;
    mesh.add(0, from, to, 0);
    const std::uint32_t left = i == 0 ? 3 : 2 + kSlices + i;
    const std::uint32_t right = i + 1 == kSlices ? 2 : 3 + kSlices + i;
    mesh.add(0, right, left, 0);
  }
  const Picture picture =
      make_picture(make_layer(mesh, [](int, Vec2 p) { return cubic_field(p); }));
  const Image image = rasterized(picture, image_size(256, 256));
  EXPECT_LT(worst_miss(image, kUnitBox, cubic_field), kAllowed);
}

/// Returns the coverage of region 1 in a white-on-black picture, 0 to 1.
double white_share(const Image& image, int x, int y) {
  return channel(image, x, y, 0) / 65535.0;
}

Rgb black_and_white(int region, Vec2) {
  const float shade = static_cast<float>(region);
  return {shade, shade, shade};
}

TEST(RasterClosedForms, an_upright_edge_covers_by_its_offset) {
  for (int step = 0; step <= 16; ++step) {
    const double edge_x = 4 + step / 16.0;
    const RegionMesh mesh = cut_box({{0, 0}, {8, 8}}, {edge_x, 8}, {edge_x, 0});
    const Image image =
        rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(8, 8));
    for (int y = 0; y < 8; ++y) {
      EXPECT_NEAR(white_share(image, 4, y), 1 - step / 16.0, 1e-4);
      EXPECT_EQ(white_share(image, 3, y), 0);
      EXPECT_EQ(white_share(image, 5, y), 1);
    }
  }
}

TEST(RasterClosedForms, a_level_edge_covers_by_its_offset) {
  for (int step = 0; step <= 16; ++step) {
    const double edge_y = 2 + step / 16.0;
    const RegionMesh mesh = cut_box({{0, 0}, {8, 8}}, {0, edge_y}, {8, edge_y});
    const Image image =
        rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(8, 8));
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(white_share(image, x, 2), 1 - step / 16.0, 1e-4);
  }
}

TEST(RasterClosedForms, a_slanted_edge_covers_the_integral_of_its_line) {
  // The area below the line y = a + b x within pixel (i, j). b is so small that the line crosses at
  // most the left and right sides of two pixels of a column.
  const double a = 3.3, b = 0.21;
  const RegionMesh mesh = cut_box({{0, 0}, {16, 16}}, {0, a}, {16, a + 16 * b});
  const Image image =
      rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(16, 16));
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      double share = 0;
      constexpr int kSteps = 4000;  // the line's height clipped to the pixel, midpoint rule
      for (int k = 0; k < kSteps; ++k)
        share += std::clamp(y + 1 - (a + b * (x + (k + 0.5) / kSteps)), 0.0, 1.0) / kSteps;
      EXPECT_NEAR(white_share(image, x, y), share, 1.0 / 2048);
    }
  }
}

TEST(RasterClosedForms, a_rotated_square_has_its_own_area) {
  for (double turn_rad = -0.35; turn_rad < 0.36; turn_rad += 0.05) {
    RegionMesh mesh;
    mesh.vertex = {{0, 0}, {32, 0}, {32, 32}, {0, 32}};
    const Vec2 center{16.3, 15.8}, arm{7 * std::cos(turn_rad), 7 * std::sin(turn_rad)};
    const Vec2 across{-arm.y, arm.x};
    // Corners beside the box's corners, clockwise from the upper left one.
    mesh.vertex.push_back(center - arm - across);
    mesh.vertex.push_back(center + arm - across);
    mesh.vertex.push_back(center + arm + across);
    mesh.vertex.push_back(center - arm + across);
    mesh.add(4, 5, 6, 1);
    mesh.add(4, 6, 7, 1);
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t next = (k + 1) % 4;
      mesh.add(k, next, 4 + next, 0);
      mesh.add(k, 4 + next, 4 + k, 0);
    }
    const Image image =
        rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(32, 32));
    double area = 0;
    for (int i = 0; i < 32 * 32; ++i) area += white_share(image, i % 32, i / 32);
    EXPECT_NEAR(area, 4 * 49, 0.01) << turn_rad;
  }
}

TEST(RasterClosedForms, a_thin_wedge_has_its_own_area) {
  RegionMesh mesh;
  mesh.vertex = {{0, 0}, {40, 0}, {40, 20}, {0, 20}, {3.2, 10.1}, {40, 10.3}, {40, 10.6}};
  mesh.add(4, 5, 6, 1);
  mesh.add(0, 1, 4, 0);
  mesh.add(1, 5, 4, 0);
  mesh.add(6, 2, 4, 0);
  mesh.add(2, 3, 4, 0);
  mesh.add(3, 0, 4, 0);
  const Image image =
      rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(40, 20));
  for (int x = 4; x < 40; ++x) {
    double column = 0;
    for (int y = 0; y < 20; ++y) column += white_share(image, x, y);
    EXPECT_NEAR(column, 0.3 * (x + 0.5 - 3.2) / 36.8, 1e-3) << x;
  }
}

TEST(RasterClosedForms, without_antialiasing_each_pixel_is_one_of_two_colours) {
  const RegionMesh mesh = cut_box({{0, 0}, {16, 16}}, {3, 16}, {12, 0});
  RasterOptions options = image_size(16, 16, PixelFormat::rgb8);
  options.antialias = false;
  const Image image = rasterized(make_picture(make_layer(mesh, black_and_white)), options);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double edge_x = 12 - 9 * (y + 0.5) / 16;
      EXPECT_EQ(channel(image, x, y, 0), x + 0.5 > edge_x ? 255 : 0);
    }
  }
}

TEST(RasterClosedForms, one_pixel_holds_the_mean_of_the_picture) {
  const RegionMesh mesh = cut_box({{0, 0}, {8, 8}}, {2, 8}, {4, 0});
  const Image image = rasterized(make_picture(make_layer(mesh, black_and_white)), image_size(1, 1));
  EXPECT_NEAR(white_share(image, 0, 0), 5.0 / 8, 1e-4);
}

}  // namespace
}  // namespace sfumato::test
