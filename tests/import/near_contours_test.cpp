// Fills of several contours that share edges or nearly touch, and the resulting pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text/number_text.hpp"
#include "sfumato/import/import_svg.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {
namespace {

using Polygon = std::vector<Vec2>;

constexpr int kPixels = 128;
constexpr double kUnitsPerPixel = 2;

bool is_in(const Polygon& polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) inside = !inside;
  }
  return inside;
}

bool is_in_any(const std::vector<Polygon>& polygons, Vec2 p) {
  return std::ranges::any_of(polygons, [&](const Polygon& polygon) { return is_in(polygon, p); });
}

/// Returns how many of nine points around a pixel's centre lie in a polygon.
int points_inside(const std::vector<Polygon>& polygons, int x, int y) {
  int count = 0;
  for (int i = 0; i < 9; ++i)
    count += is_in_any(polygons, Vec2{x + i % 3 - 0.5, y + i / 3 - 0.5} * kUnitsPerPixel);
  return count;
}

std::string text_of(const std::vector<Polygon>& polygons) {
  std::string text;
  for (const Polygon& polygon : polygons) {
    char command = 'M';
    for (const Vec2 p : polygon) {
      text += command + number_text(p.x) + ' ' + number_text(p.y);
      command = 'L';
    }
    text += 'z';
  }
  return text;
}

Image drawn(const std::vector<Polygon>& polygons) {
  const std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 256 256'><path fill='#008000' d='" +
      text_of(polygons) + "'/></svg>";
  Context context;
  const auto made = import_svg(context, svg, "near.svg");
  EXPECT_TRUE(made);
  const auto picture = diffuse(context, made->document, {});
  EXPECT_TRUE(picture);
  RasterOptions options;
  options.width = options.height = kPixels;
  auto image = rasterize(context, *picture, options);
  EXPECT_TRUE(image);
  return std::move(*image);
}

/// Expects green inside and white outside; pixels near a border may have any colour in between.
/// Along a slit of width `gap`, as much white may show.
void expect_filled(const std::vector<Polygon>& polygons, const std::string& name, double gap = 0) {
  const int allowed = 2 + static_cast<int>(255 * 1.5 * gap / kUnitsPerPixel);
  const Image image = drawn(polygons);
  int wrong = 0;
  for (int y = 0; y < kPixels; ++y) {
    for (int x = 0; x < kPixels; ++x) {
      const int inside = points_inside(polygons, x, y);
      if (inside > 0 && inside < 9) continue;
      const std::uint8_t* pixel = image.bytes.data() + 3 * (kPixels * y + x);
      const int red = inside > 0 ? 0 : 255, green = inside > 0 ? 128 : 255;
      wrong += std::abs(pixel[0] - red) > allowed || std::abs(pixel[1] - green) > allowed;
    }
  }
  EXPECT_EQ(wrong, 0) << name << ": " << text_of(polygons);
}

Polygon box(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

TEST(NearContours, a_slit_of_any_width_loses_no_colour) {
  for (const double gap :
       {0.0, 1e-5, 1e-4, 2e-4, 3e-4, 5e-4, 1e-3, 3e-3, 0.01, 0.0156, 0.016, 0.02, 0.03, 0.06}) {
    const std::string name = "gap " + number_text(gap);
    expect_filled({box(20, 20, 100, 230), box(100 + gap, 60, 220, 180)}, name, gap);
    expect_filled(
        {box(20, 20, 100, 230), {{100 + gap, 60}, {220, 70}, {220, 180}, {100 + gap, 180}}}, name,
        gap);
    expect_filled({{{20, 20}, {200, 140}, {20, 230}},
                   {{80 + gap, 60 - gap}, {140 + gap, 100 - gap}, {220, 20}}},
                  name, gap);
  }
}

TEST(NearContours, shared_edges_at_any_angle_lose_no_colour) {
  const std::vector<std::vector<Polygon>> shapes{
      {box(60, 60, 160, 120), box(80, 120, 140, 180)},
      {box(60, 60, 160, 120), {{120, 120}, {190, 120}, {190, 170}, {90, 170}, {90, 120}}},
      {box(60, 60, 160, 180), box(160, 90, 200, 120), box(160, 120, 220, 150)}};
  for (int i = 1; i < 16; ++i) {
    const double angle = i * 0.0925;
    const auto turned = [&](Vec2 p) {
      const Vec2 from = p - Vec2{128, 128};
      return Vec2{128 + from.x * std::cos(angle) - from.y * std::sin(angle),
                  128 + from.x * std::sin(angle) + from.y * std::cos(angle)};
    };
    for (std::vector<Polygon> shape : shapes) {
      for (Polygon& polygon : shape) std::ranges::transform(polygon, polygon.begin(), turned);
      expect_filled(shape, "angle " + number_text(angle));
    }
  }
}

TEST(NearContours, ways_there_and_back_lose_no_colour) {
  expect_filled({{{40, 40}, {200, 40}, {200, 120}, {240, 130}, {200, 120}, {200, 200}, {40, 200}}},
                "a spike");
  expect_filled({{{40, 40}, {200, 40}, {200, 200}, {120, 200}, {121, 90}, {120, 200}, {40, 200}}},
                "a slit");
}

}  // namespace
}  // namespace sfumato
