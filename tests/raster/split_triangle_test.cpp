// The parts of a triangle on both sides of a line, compared with the triangle cut by pixels.
#include "raster/coverage/split_triangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "raster/coverage/clip.hpp"

namespace sfumato::test {
namespace {

using raster::Coverage;
using raster::SplitPart;

constexpr int kX = 4, kY = 7;

/// A triangle in pixels (kX, kY) and (kX + 1, kY), clockwise on the screen; some corners lie on a
/// grid of quarters, and so also on the border.
struct Triangle {
  explicit Triangle(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    do {
      for (Vec2& p : corner) {
        p = {2 * unit(random), unit(random)};
        if (random() % 3 == 0) p = {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4};
        p = p + Vec2{kX, kY};
      }
    } while (!is_parted());
    if (area() < 0) std::swap(corner[1], corner[2]);
  }

  double distance(int k) const { return corner[k].x - (kX + 1); }
  double area() const { return 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]); }
  bool is_parted() const {
    const auto [low, high] = std::minmax({distance(0), distance(1), distance(2)});
    return low < 0 && high > 0 && area() != 0;
  }

  Vec2 corner[3];
};

void expect_part(const Triangle& triangle, const SplitPart& part, int x) {
  const auto& corner = triangle.corner;
  const Coverage expected =
      raster::pixel_coverage(raster::clip_triangle(corner[0], corner[1], corner[2]), x, kY);
  const double area = part.share * triangle.area();
  EXPECT_NEAR(area, expected.area, 1e-14);
  const Vec2 centroid = corner[0] + (corner[1] - corner[0]) * part.u +
                        (corner[2] - corner[0]) * part.v - Vec2{1.0 * x, 1.0 * kY};
  EXPECT_NEAR(area * centroid.x, expected.area * expected.centroid.x, 1e-14);
  EXPECT_NEAR(area * centroid.y, expected.area * expected.centroid.y, 1e-14);
}

TEST(SplitTriangle, both_parts_are_those_of_the_triangle_cut_by_pixels) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    const Triangle triangle(random);
    const raster::SplitTriangle split =
        raster::split_triangle({triangle.distance(0), triangle.distance(1), triangle.distance(2)});
    expect_part(triangle, split.below, kX);
    expect_part(triangle, split.above, kX + 1);
    if (HasFailure()) FAIL() << "triangle " << i;
  }
}

TEST(SplitTriangle, a_side_with_nothing_but_an_edge_has_no_share) {
  const raster::SplitTriangle split = raster::split_triangle({0, 0, 2});
  EXPECT_EQ(split.below.share, 0);
  EXPECT_EQ(split.above.share, 1);
  EXPECT_DOUBLE_EQ(split.above.u, 1.0 / 3);
  EXPECT_DOUBLE_EQ(split.above.v, 1.0 / 3);
}

}  // namespace
}  // namespace sfumato::test
