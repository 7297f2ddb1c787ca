#include "curves/bezier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace sfumato::curves {
namespace {

/// A quarter of the unit circle, within 3e-4.
constexpr double kCircle = 0.5522847498307936;
const Cubic kQuarter{Vec2{1, 0}, Vec2{1, kCircle}, Vec2{kCircle, 1}, Vec2{0, 1}};

Cubic random_cubic(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-10, 10);
  Cubic cubic;
  for (Vec2& p : cubic) p = {coordinate(random), coordinate(random)};
  return cubic;
}

TEST(Bezier, point_is_exact_at_both_ends) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Cubic cubic = random_cubic(random);
    EXPECT_EQ(point_at(cubic, 0), cubic[0]);
    EXPECT_EQ(point_at(cubic, 1), cubic[3]);
  }
}

TEST(Bezier, derivative_is_the_limit_of_differences) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Cubic cubic = random_cubic(random);
    const double t = 0.3, h = 1e-5;
    const Vec2 difference = (point_at(cubic, t + h) - point_at(cubic, t - h)) / (2 * h);
    EXPECT_NEAR(length(difference - derivative_at(cubic, t)), 0, 1e-6);
  }
}

TEST(Bezier, subcurve_traces_the_same_points) {
  std::mt19937 random(3);
  const Cubic cubic = random_cubic(random);
  const Cubic part = subcurve(cubic, 0.2, 0.7);
  for (double t = 0; t <= 1; t += 0.125) {
    EXPECT_NEAR(length(point_at(part, t) - point_at(cubic, 0.2 + 0.5 * t)), 0, 1e-12);
  }
}

TEST(Bezier, chord_deviation_is_the_largest_sampled_deviation) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Cubic cubic = random_cubic(random);
    const Vec2 along = (cubic[3] - cubic[0]) / length(cubic[3] - cubic[0]);
    double across_seen = 0, along_seen = 0;
    for (int k = 0; k <= 4000; ++k) {
      const double t = k / 4000.0;
      const Vec2 gap = point_at(cubic, t) - lerp(cubic[0], cubic[3], t);
      across_seen = std::max(across_seen, std::fabs(cross(along, gap)));
      along_seen = std::max(along_seen, std::fabs(dot(along, gap)));
    }
    const ChordDeviation deviation = chord_deviation(cubic);
    EXPECT_NEAR(deviation.across, across_seen, 1e-5 * (1 + across_seen));
    EXPECT_NEAR(deviation.along, along_seen, 1e-5 * (1 + along_seen));
  }
}

TEST(Bezier, a_loop_without_a_chord_deviates) {
  const Cubic loop{Vec2{0, 0}, Vec2{3, 0}, Vec2{0, 3}, Vec2{0, 0}};
  EXPECT_GT(chord_deviation(loop).across, 1);
}

TEST(Bezier, arc_length_of_a_quarter_circle_is_half_pi) {
  EXPECT_NEAR(arc_length(kQuarter, 0, 1), std::numbers::pi / 2, 1e-3);
  EXPECT_NEAR(arc_length(kQuarter, 0, 0.4) + arc_length(kQuarter, 0.4, 1),
              arc_length(kQuarter, 0, 1), 1e-8);
}

TEST(Bezier, parameter_at_length_inverts_arc_length) {
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const Cubic cubic = random_cubic(random);
    for (double t : {0.001, 0.1, 0.5, 0.83, 0.999}) {
      EXPECT_NEAR(parameter_at_length(cubic, arc_length(cubic, 0, t)), t, 1e-8);
    }
  }
}

TEST(Bezier, parameter_at_length_settles_where_the_speed_is_zero) {
  // 0 at the start, at the end, and in the middle.
  const Cubic from_rest{{{0, 0}, {0, 0}, {0, 0}, {1, 0}}};
  const Cubic to_rest{{{0, 0}, {1, 0}, {1, 0}, {1, 0}}};
  const Cubic cusp{{{0, 0}, {1, 1}, {0, 1}, {1, 0}}};
  for (double t : {0.02, 0.3, 0.5, 0.7, 0.98}) {
    EXPECT_NEAR(parameter_at_length(from_rest, t * t * t), t, 1e-6);
    EXPECT_NEAR(parameter_at_length(to_rest, 1 - (1 - t) * (1 - t) * (1 - t)), t, 1e-6);
    const double length = arc_length(cusp, 0, t);
    EXPECT_NEAR(arc_length(cusp, 0, parameter_at_length(cusp, length)), length, 1e-6);
  }
}

TEST(Bezier, parameter_at_length_ends_with_the_curve) {
  const Cubic point{{{2, 3}, {2, 3}, {2, 3}, {2, 3}}};
  const Cubic line{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}};
  EXPECT_NEAR(parameter_at_length(line, 0), 0, 1e-12);
  EXPECT_NEAR(parameter_at_length(line, 1.5), 0.5, 1e-12);
  EXPECT_NEAR(parameter_at_length(line, 3.0001), 1, 1e-12);
  const double nowhere = parameter_at_length(point, 1);
  EXPECT_TRUE(nowhere >= 0 && nowhere <= 1);
}

}  // namespace
}  // namespace sfumato::curves
