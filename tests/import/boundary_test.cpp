// Boundaries of filled contours, point by point.
#include "import/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/segment.hpp"
#include "curves/bezier.hpp"
#include "import/stroke_outline.hpp"

namespace sfumato::svg_import {
namespace {

constexpr double kBoundaryTolerance = 60.0 / 16384;
constexpr int kPointsPerPiece = 2000;

std::vector<Vec2> points_along(const std::vector<Vec2>& chain, int per_piece) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; 3 * i + 3 < chain.size(); ++i) {
    const curves::Cubic cubic = curves::piece(chain, i);
    for (int k = 0; k <= per_piece; ++k) {
      points.push_back(curves::point_at(cubic, double{1} * k / per_piece));
    }
  }
  return points;
}

/// Returns the largest distance from points of the boundary to the contour.
double farthest_from(const std::vector<Vec2>& contour, const Contours& boundary) {
  const std::vector<Vec2> there = points_along(contour, kPointsPerPiece);
  double farthest = 0;
  for (const std::vector<Vec2>& loop : boundary) {
    for (const Vec2 p : points_along(loop, 20)) {
      double nearest = INFINITY;
      for (const Vec2 q : there) nearest = std::min(nearest, length(p - q));
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

/// Expects a boundary that follows the closed contour.
void expect_on(std::vector<Vec2> contour, const std::string& name) {
  Context context;
  const auto boundary = fill_boundary(context, {contour}, false, kBoundaryTolerance);
  ASSERT_TRUE(boundary) << name;
  EXPECT_FALSE(boundary->empty()) << name;
  const Vec2 begin = contour.front(), end = contour.back();
  contour.insert(contour.end(), {lerp(end, begin, 1.0 / 3), lerp(end, begin, 2.0 / 3), begin});
  EXPECT_LE(farthest_from(contour, *boundary), 8 * kBoundaryTolerance) << name;
}

TEST(FillBoundary, follows_a_crescent_whose_curves_run_back_into_each_other) {
  expect_on({{12.135, 70.771},
             {16.143, 64.96},
             {18.215, 60.8},
             {24.115, 56.65},
             {29.519, 52.848},
             {35.795, 50.26},
             {42.395, 49.596},
             {15.727, 52.272},
             {-2.128, 83.52},
             {.205, 108.452}},
            "crescent");
}

/// Returns the distance of a point from the outline of straight pieces.
double distance_from(const std::vector<Vec2>& chain, Vec2 p) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i + 3 < chain.size(); i += 3)
    nearest = std::min(nearest, length(p - nearest_on_segment(p, chain[i], chain[i + 3])));
  return nearest;
}

TEST(FillBoundary, meets_where_straight_curves_of_uneven_speed_cross) {
  const double speeds[][2] = {{0.5, 0.5}, {0, 1}, {0, 0}, {1, 1}, {0.02, 0.04}, {0.9, 0.97}};
  for (const auto& [first, second] : speeds) {
    std::vector<Vec2> star;
    for (int i = 0; i <= 5; ++i) {
      const double angle = 0.3 + 0.8 * std::numbers::pi * i;
      const Vec2 tip{50 + 40 * std::cos(angle), 50 + 40 * std::sin(angle)};
      if (i > 0) {
        const Vec2 from = star.back();
        star.insert(star.end(), {lerp(from, tip, first), lerp(from, tip, second)});
      }
      star.push_back(tip);
    }
    Context context;
    const auto boundary = fill_boundary(context, {star}, false, kBoundaryTolerance);
    ASSERT_TRUE(boundary);
    double farthest = 0;
    for (const std::vector<Vec2>& loop : *boundary)
      for (const Vec2 p : points_along(loop, 50))
        farthest = std::max(farthest, distance_from(star, p));
    EXPECT_LE(farthest, kBoundaryTolerance) << "speeds " << first << ", " << second;
  }
}

/// The parameters of the chord's ends are far apart: the curve nearly stops at the corner.
TEST(FillBoundary, of_a_stroke_ends_near_a_corner_where_the_curves_stop) {
  const std::vector<Vec2> teeth{{287.15045, 416.40848}, {287.15045, 416.40848},
                                {249.13214, 407.80025}, {246.11842, 392.73167},
                                {245.39136, 401.10125}, {241.09556, 423.57924},
                                {241.09556, 423.57924}, {241.09556, 423.57924},
                                {209.95384, 383.69053}, {208.94927, 373.64481}};
  const double tolerance = 733.0 / 16384;
  Context context;
  const auto outline = stroke_outline(context, {teeth}, {.width = 1}, tolerance);
  ASSERT_TRUE(outline);
  const auto boundary = fill_boundary(context, *outline, false, tolerance);
  ASSERT_TRUE(boundary);
  EXPECT_LE(farthest_from(teeth, *boundary), 2.1) << "the miter limit, 4 × 1/2";
}

std::vector<Vec2> polygon(const std::vector<Vec2>& corners) {
  std::vector<Vec2> chain{corners.front()};
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const Vec2 from = chain.back(), to = corners[i % corners.size()];
    chain.insert(chain.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
  }
  return chain;
}

TEST(FillBoundary, keeps_thin_parts_and_thinner_holes) {
  const std::vector<Vec2> square = polygon({{10, 10}, {50, 10}, {50, 50}, {10, 50}});
  for (const double width : {1.0, 3.0, 6.0}) {
    const double half = width * kBoundaryTolerance / 2;
    const auto diamond = polygon({{30 - half, 5}, {30, 4}, {30 + half, 5}, {30, 6}});
    auto hole = diamond;
    for (Vec2& p : hole) p.y += 25;
    Context context;
    const auto part = fill_boundary(context, {square, diamond}, true, kBoundaryTolerance);
    const auto holed = fill_boundary(context, {square, hole}, true, kBoundaryTolerance);
    ASSERT_TRUE(part && holed);
    EXPECT_EQ(part->size(), width < 4 ? 1u : 2u) << "width " << width;
    EXPECT_EQ(holed->size(), width < 2 ? 1u : 2u) << "width " << width;
  }
}

TEST(FillBoundary, follows_crescents_with_nearly_tangent_tips) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  for (int i = 0; i < 40; ++i) {
    // Both curves leave the tip in nearly one direction.
    const Vec2 tip{number(30, 50), number(0, 20)}, away{-number(5, 20), number(-1, 3)};
    const Vec2 turned = away * number(0.5, 3) + Vec2{0, number(-1e-2, 1e-2)};
    const Vec2 from{number(0, 10), number(40, 60)}, to{number(0, 10), number(60, 70)};
    expect_on({from, from + Vec2{number(0, 9), -number(5, 20)}, tip + away, tip, tip + turned,
               to + Vec2{-number(0, 9), -number(5, 30)}, to},
              std::to_string(i));
  }
}

}  // namespace
}  // namespace sfumato::svg_import
