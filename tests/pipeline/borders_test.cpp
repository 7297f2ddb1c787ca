// The border of visibility, from document to pixels: shadows of barriers, whose borders are known
// in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "raster/reference.hpp"
#include "raster/support.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"

namespace sfumato::test {
namespace {

const Affine kTurns[] = {{1, 0, 0, 1, 0, 0},
                         {0.8, 0.6, -0.6, 0.8, 41, -21},
                         {-1, 0, 0, 1, 100, 0},
                         {0.28, 0.96, -0.96, 0.28, 87, -9.7}};

Curve barrier(Vec2 from, Vec2 to) {
  Curve curve = straight_curve(from, to);
  curve.left.color.kind = curve.right.color.kind = ShaderKind::barrier;
  return curve;
}

/// Returns a light that shines to the right from (10, 45) to (10, 55), and a wall at x = 40 before
/// it.
Document wall_before_light(const Affine& turn, double wall_top, double wall_bottom) {
  Curve light = straight_curve(turn({10, 45}), turn({10, 55}));
  light.left.color = one_color({0.8f, 0.3f, 0.1f});
  light.right.color.kind = ShaderKind::barrier;
  if (turn.determinant() < 0) std::swap(light.left, light.right);
  return one_layer({light, barrier(turn({40, wall_top}), turn({40, wall_bottom}))});
}

/// Returns the area that the light of wall_before_light does not reach, as convex polygons.
std::vector<std::vector<Vec2>> dark_parts(double wall_top, double wall_bottom) {
  constexpr double kFar = 400;
  std::vector<std::vector<Vec2>> parts{{{-kFar, -kFar}, {10, -kFar}, {10, kFar}, {-kFar, kFar}}};
  // Lines along which the closer end of the light is visible past each end of the wall.
  const double upper = (wall_top - 45) / 30, lower = (wall_bottom - 55) / 30;
  const double meet = upper < lower ? kFar : 40 + (wall_bottom - wall_top) / (upper - lower);
  parts.push_back({{40, wall_top},
                   {meet, wall_top + upper * (meet - 40)},
                   {meet, wall_bottom + lower * (meet - 40)},
                   {40, wall_bottom}});
  return parts;
}

double area_in_pixel(std::vector<Vec2> polygon, double scale, int x, int y) {
  for (Vec2& p : polygon) p = p * scale;
  polygon = cut_polygon(polygon, {-1, 0}, -x);
  polygon = cut_polygon(polygon, {1, 0}, x + 1);
  polygon = cut_polygon(polygon, {0, -1}, -y);
  polygon = cut_polygon(polygon, {0, 1}, y + 1);
  double area = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
  return std::fabs(area);
}

/// Returns the largest error of a pixel's alpha, code values.
double worst_alpha(const Affine& turn, double wall_top, double wall_bottom, double max_error,
                   int side) {
  Context context;
  DiffuseOptions options;
  options.max_error = max_error;
  options.pixels_per_unit = side / 100.0;
  const Document document = wall_before_light(turn, wall_top, wall_bottom);
  const Result<Picture> picture = diffuse(context, document, options);
  EXPECT_TRUE(picture.ok());
  const Image image = rasterized(*picture, image_size(side, side, PixelFormat::rgba8));
  double worst = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      double area = 1;
      for (std::vector<Vec2> part : dark_parts(wall_top, wall_bottom)) {
        for (Vec2& p : part) p = turn(p);
        area -= area_in_pixel(part, side / 100.0, x, y);
      }
      const double miss = std::fabs(channel(image, x, y, 3) - 255 * area);
      worst = std::max(worst, miss);
    }
  }
  return worst;
}

TEST(Borders, the_shadow_of_a_wall_is_antialiased_where_it_lies) {
  for (const Affine& turn : kTurns) {
    EXPECT_LE(worst_alpha(turn, 31.3, 68.1, 1, 100), 3) << turn.a;
    EXPECT_LE(worst_alpha(turn, 31.3, 68.1, 1, 317), 3) << turn.a;
  }
}

TEST(Borders, they_need_no_fine_mesh) {
  for (const Affine& turn : kTurns) {
    EXPECT_LE(worst_alpha(turn, 31.3, 68.1, 0, 100), 3) << turn.a;
    EXPECT_LE(worst_alpha(turn, 31.3, 68.1, 0, 317), 4) << turn.a;
  }
}

TEST(Borders, colours_next_to_them_are_those_of_the_seen_side) {
  Context context;
  const Result<Picture> picture = diffuse(context, wall_before_light(kTurns[1], 31.3, 68.1), {});
  ASSERT_TRUE(picture.ok());
  const Image image = rasterized(*picture, image_size(200, 200, PixelFormat::rgba16));
  for (int i = 0; i < 200 * 200; ++i) {
    const int x = i % 200, y = i / 200;
    if (channel(image, x, y, 3) < 3000) continue;
    ASSERT_NEAR(channel(image, x, y, 0), 0.8 * 65535, 40) << x << ' ' << y;
    ASSERT_NEAR(channel(image, x, y, 1), 0.3 * 65535, 40) << x << ' ' << y;
  }
}

TEST(Borders, a_layer_of_barriers_alone_shows_nothing) {
  Context context;
  const Document document = one_layer({barrier({10, 10}, {80, 40}), barrier({10, 60}, {60, 30})});
  const Result<Picture> picture = diffuse(context, document, {});
  ASSERT_TRUE(picture.ok());
  const Image image = rasterized(*picture, image_size(100, 100, PixelFormat::rgba8));
  for (std::uint8_t byte : image.bytes) ASSERT_EQ(byte, 0);
}

TEST(Borders, a_circle_with_nothing_outside_has_an_antialiased_rim) {
  Curve circle = circle_curve({50, 50}, 40.3);
  circle.right.color = one_color({0.8f, 0, 0.1f});
  circle.left.color.kind = ShaderKind::barrier;
  Context context;
  DiffuseOptions options;
  options.pixels_per_unit = 2;
  options.tolerance = 0.002;
  const Result<Picture> picture = diffuse(context, one_layer({circle}), options);
  ASSERT_TRUE(picture.ok());
  const Image image = rasterized(*picture, image_size(200, 200, PixelFormat::rgba8));
  std::array<int, 256> count{};
  double sum = 0;
  for (int i = 0; i < 200 * 200; ++i) {
    ++count[static_cast<std::size_t>(channel(image, i % 200, i / 200, 3))];
    sum += channel(image, i % 200, i / 200, 3) / 255.0;
  }
  EXPECT_GE(256 - std::count(count.begin(), count.end(), 0), 60);
  EXPECT_NEAR(sum / 4, std::numbers::pi * 40.3 * 40.3, 2);
}

}  // namespace
}  // namespace sfumato::test
