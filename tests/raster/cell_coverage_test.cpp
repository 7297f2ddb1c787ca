// The parts of small triangles in all cells at once, compared with cutting the triangle for each
// pixel.
#include "raster/coverage/cell_coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "raster/pictures.hpp"

namespace sfumato::test {
namespace {

using raster::CellCoverage;
using raster::Coverage;

class Random {
 public:
  explicit Random(std::uint32_t seed) : random_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (random_() / 4294967296.0);
  }
  /// Returns a point in a square; one of three lies on a grid of half cells, so that edges run
  /// along cells.
  Vec2 point(Vec2 corner, double side) {
    const Vec2 p{uniform(corner.x, corner.x + side), uniform(corner.y, corner.y + side)};
    if (random_() % 3 != 0) return p;
    return {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
  }

 private:
  std::mt19937 random_;
};

bool cut(CellCoverage& cells, const Vec2 (&corner)[3]) {
  Box box;
  for (Vec2 p : corner) box.extend(p);
  return cells.cut(corner, box);
}

/// Compares area and moments in every cell that the triangle may touch, and around it. Returns the
/// sum of the areas.
double expect_parts(const CellCoverage& cells, const Vec2 (&corner)[3]) {
  const raster::ClipTriangle clip = raster::clip_triangle(corner[0], corner[1], corner[2]);
  Box box;
  for (Vec2 p : corner) box.extend(p);
  double sum = 0;
  for (int y = static_cast<int>(std::floor(box.min.y)) - 1; y <= box.max.y + 1; ++y) {
    for (int x = static_cast<int>(std::floor(box.min.x)) - 1; x <= box.max.x + 1; ++x) {
      const Coverage part = cells.in(x, y), expected = raster::pixel_coverage(clip, x, y);
      EXPECT_GE(part.area, 0);
      EXPECT_NEAR(part.area, expected.area, 1e-12) << x << ' ' << y;
      EXPECT_NEAR(part.area * part.centroid.x, expected.area * expected.centroid.x, 1e-12);
      EXPECT_NEAR(part.area * part.centroid.y, expected.area * expected.centroid.y, 1e-12);
      sum += part.area;
    }
  }
  return sum;
}

TEST(CellCoverage, the_parts_of_a_triangle_are_those_of_the_triangle_cut_by_each_pixel) {
  Random random(11);
  CellCoverage cells;
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    const double side = std::exp(random.uniform(-6, 2));
    const Vec2 at{random.uniform(-9000, 9000), random.uniform(-20, 20)};
    Vec2 corner[3];
    for (Vec2& p : corner) p = random.point(at, side);
    const double doubled = cross(corner[1] - corner[0], corner[2] - corner[0]);
    if (doubled < 0) std::swap(corner[1], corner[2]);
    if (!cut(cells, corner)) continue;
    EXPECT_NEAR(expect_parts(cells, corner), std::fabs(doubled) / 2, 1e-11);
    count += std::fabs(doubled) > 0;
  }
  EXPECT_GT(count, 15000);
}

TEST(CellCoverage, areas_of_all_triangles_in_a_cell_sum_to_one) {
  const RegionMesh mesh = jittered_grid({{-3, -3}, {11, 11}}, 17, 21);
  for (double scale : {1.0, 1.9, 3.7}) {
    double sum[8][8] = {};
    CellCoverage cells;
    for (const Corners& corner : mesh.triangle) {
      ASSERT_TRUE(cut(cells, {mesh.vertex[corner[0]] * scale, mesh.vertex[corner[1]] * scale,
                              mesh.vertex[corner[2]] * scale}));
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) sum[y][x] += cells.in(x, y).area;
    }
    for (const auto& row : sum)
      for (double area : row) EXPECT_NEAR(area, 1, 1e-11);
  }
}

TEST(CellCoverage, a_triangle_that_is_the_half_of_a_square_has_its_thirds) {
  CellCoverage cells;
  ASSERT_TRUE(cut(cells, {{2, -3}, {4, -3}, {2, -1}}));
  EXPECT_DOUBLE_EQ(cells.in(2, -3).area, 1);
  EXPECT_DOUBLE_EQ(cells.in(2, -3).centroid.x, 0.5);
  EXPECT_DOUBLE_EQ(cells.in(3, -3).area, 0.5);
  EXPECT_DOUBLE_EQ(cells.in(3, -3).centroid.x, 1.0 / 3);
  EXPECT_DOUBLE_EQ(cells.in(2, -2).centroid.y, 1.0 / 3);
  EXPECT_EQ(cells.in(3, -2).area, 0);
  EXPECT_EQ(cells.in(1, -3).area, 0);
  EXPECT_EQ(cells.in(4, -3).area, 0);
}

TEST(CellCoverage, triangles_that_are_large_or_far_away_or_none_are_refused) {
  CellCoverage cells;
  const double nan = std::nan("");
  EXPECT_FALSE(cut(cells, {{0, 0}, {9, 0}, {0, 9}}));
  EXPECT_FALSE(cut(cells, {{0, 0}, {1000, 0.1}, {0, 0.2}}));
  EXPECT_FALSE(cut(cells, {{1e7, 0}, {1e7 + 1, 0}, {1e7, 1}}));
  EXPECT_FALSE(cut(cells, {{1e300, -1e300}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(cut(cells, {{0, 0}, {nan, 0}, {0, 1}}));
  EXPECT_TRUE(cut(cells, {{0, 0}, {7.5, 0}, {0, 7.5}}));
}

TEST(CellCoverage, a_line_has_no_parts) {
  CellCoverage cells;
  ASSERT_TRUE(cut(cells, {{0.25, 0.5}, {2.75, 1.5}, {1.5, 1}}));
  for (int y = -1; y < 4; ++y)
    for (int x = -1; x < 4; ++x) EXPECT_EQ(cells.in(x, y).area, 0);
}

}  // namespace
}  // namespace sfumato::test
