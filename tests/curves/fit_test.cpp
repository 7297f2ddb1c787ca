// Béziers fitted to points: their distance, their smooth joints, and that bad chains end as well.
#include "curves/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "curves/bezier.hpp"
#include "curves/distance.hpp"

namespace sfumato::curves {
namespace {

constexpr int kParts = 64;  ///< parts per piece for flattening

std::vector<Vec2> fitted(std::span<const Vec2> points, const FitOptions& options) {
  std::vector<Vec2> control_points;
  fit_curve(points, options, control_points);
  EXPECT_LE(control_points.size(), most_control_points(points.size()));
  return control_points;
}

/// Returns the distance from a point to the curve, by its flattened pieces.
double distance_to(const std::vector<Vec2>& control_points, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; 3 * i + 1 < control_points.size(); ++i) {
    const Cubic cubic = piece(control_points, i);
    for (int k = 0; k < kParts; ++k) {
      const Vec2 a = point_at(cubic, double(k) / kParts), b = point_at(cubic, (k + 1.0) / kParts);
      least = std::min(least, test::distance_to_segment(p, a, b));
    }
  }
  return least;
}

/// Returns a stroke like a hand-drawn one: a few waves of random size and phase, sampled about a
/// unit apart.
std::vector<Vec2> random_stroke(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi), size(2, 20);
  std::vector<std::pair<double, double>> waves;
  for (int i = 0; i < 3; ++i) {
    const double height = size(random);
    waves.emplace_back(height, phase(random));
  }
  std::vector<Vec2> points;
  for (int i = 0; i < 200; ++i) {
    double y = 0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      y += waves[k].first * std::sin((k + 1.0) * i / 40.0 + waves[k].second);
    }
    points.push_back({double(i), y});
  }
  return points;
}

std::vector<Vec2> circle_of_points(double radius, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  points.push_back(points.front());
  return points;
}

/// Returns whether the point is the end of a piece.
bool is_joint(const std::vector<Vec2>& control_points, Vec2 p) {
  for (std::size_t i = 0; i < control_points.size(); i += 3) {
    if (control_points[i] == p) return true;
  }
  return false;
}

TEST(FitCurve, passes_within_the_tolerance_of_every_point) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec2> points = random_stroke(seed);
    for (const double tolerance : {0.1, 0.5, 2.0}) {
      const std::vector<Vec2> curve = fitted(points, {.tolerance = tolerance});
      ASSERT_EQ(curve.size() % 3, 1u);
      EXPECT_EQ(curve.front(), points.front());
      EXPECT_EQ(curve.back(), points.back());
      for (const Vec2 p : points) {
        ASSERT_LE(distance_to(curve, p), tolerance + 0.01) << "seed " << seed;
      }
    }
  }
}

TEST(FitCurve, needs_fewer_pieces_for_a_larger_tolerance) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec2> points = random_stroke(seed);
    EXPECT_LT(fitted(points, {.tolerance = 2}).size(), fitted(points, {.tolerance = 0.02}).size());
    EXPECT_LT(fitted(points, {.tolerance = 0.5}).size(), points.size());
  }
}

TEST(FitCurve, keeps_corners_as_ends_of_pieces) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 30; ++i) points.push_back({double(i), 0});
  for (int i = 1; i <= 30; ++i) points.push_back({30, double(i)});
  const std::vector<Vec2> curve = fitted(points, {.tolerance = 1});
  EXPECT_EQ(curve.size(), 7u);
  EXPECT_TRUE(is_joint(curve, {30, 0}));
  for (const Vec2 p : points) EXPECT_LE(distance_to(curve, p), 1e-9);
}

TEST(FitCurve, keeps_the_corners_of_a_loop_that_begins_between_them) {
  std::vector<Vec2> points;
  for (int i = 15; i < 30; ++i) points.push_back({double(i), 0});
  for (int i = 0; i < 30; ++i) points.push_back({30, double(i)});
  for (int i = 30; i > 0; --i) points.push_back({double(i), 30});
  for (int i = 30; i > 0; --i) points.push_back({0, double(i)});
  for (int i = 0; i <= 15; ++i) points.push_back({double(i), 0});
  ASSERT_EQ(points.front(), points.back());
  const std::vector<Vec2> curve = fitted(points, {.tolerance = 1});
  EXPECT_EQ(curve.size(), 13u);
  EXPECT_EQ(curve.front(), curve.back());
  for (const Vec2 corner : {Vec2{30, 0}, Vec2{30, 30}, Vec2{0, 30}, Vec2{0, 0}}) {
    EXPECT_TRUE(is_joint(curve, corner)) << corner.x << ' ' << corner.y;
  }
}

TEST(FitCurve, closes_a_smooth_loop_with_one_tangent_at_its_seam) {
  for (const double radius : {5.0, 20.0, 100.0}) {
    const std::vector<Vec2> points =
        circle_of_points(radius, static_cast<int>(2 * std::numbers::pi * radius));
    const std::vector<Vec2> curve = fitted(points, {.tolerance = 0.2});
    ASSERT_EQ(curve.front(), curve.back());
    const Vec2 out = curve[1] - curve[0], in = curve.back() - curve[curve.size() - 2];
    EXPECT_GT(length(out), 0);
    EXPECT_GT(length(in), 0);
    EXPECT_NEAR(dot(in, out) / (length(in) * length(out)), 1, 1e-9);
    for (const Vec2 p : points) EXPECT_LE(distance_to(curve, p), 0.21);
  }
}

TEST(FitCurve, is_smooth_where_pieces_of_a_smooth_stroke_meet) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec2> curve = fitted(random_stroke(seed), {.tolerance = 0.1});
    for (std::size_t i = 3; i + 1 < curve.size(); i += 3) {
      const Vec2 in = curve[i] - curve[i - 1], out = curve[i + 1] - curve[i];
      EXPECT_GT(dot(in, out), 0.9999 * length(in) * length(out)) << "seed " << seed;
    }
  }
}

TEST(FitCurve, makes_a_straight_piece_of_two_points) {
  const std::vector<Vec2> curve = fitted(std::vector<Vec2>{{1, 2}, {7, 5}}, {});
  ASSERT_EQ(curve.size(), 4u);
  EXPECT_EQ(curve[0], (Vec2{1, 2}));
  EXPECT_NEAR(length(curve[1] - Vec2{3, 3}), 0, 1e-12);
  EXPECT_NEAR(length(curve[2] - Vec2{5, 4}), 0, 1e-12);
  EXPECT_EQ(curve[3], (Vec2{7, 5}));
}

TEST(FitCurve, follows_a_long_zigzag) {
  std::vector<Vec2> points;
  for (int i = 0; i < 20'000; ++i) points.push_back({double(i), i % 2 == 0 ? 0.0 : 10.0});
  const std::vector<Vec2> curve = fitted(points, {.tolerance = 0.5});
  EXPECT_EQ(curve.size() % 3, 1u);
  for (std::size_t i = 0; i < points.size(); i += 997) {
    EXPECT_LE(distance_to(curve, points[i]), 0.51);
  }
}

TEST(FitCurve, follows_points_that_fall_together) {
  std::vector<Vec2> points(30, Vec2{4, 4});
  for (int i = 0; i < 30; ++i) points.push_back({4 + 0.5 * i, 4});
  points.insert(points.end(), 30, points.back());
  const std::vector<Vec2> curve = fitted(points, {.tolerance = 0.25});
  for (const Vec2 p : curve) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  for (const Vec2 p : points) EXPECT_LE(distance_to(curve, p), 0.26);
}

}  // namespace
}  // namespace sfumato::curves
