#include "picture/patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "solve/fields/angle.hpp"

namespace sfumato {
namespace {

constexpr PatchOrder kOrders[] = {PatchOrder::linear, PatchOrder::quadratic, PatchOrder::cubic};

std::array<double, 3> random_barycentric(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  double u = unit(random), v = unit(random);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return {1 - u - v, u, v};
}

/// Interpolates a function given at the ten nodes.
template <class Function>
double interpolate(PatchOrder order, const std::array<double, 3>& b, Function f) {
  const auto basis = patch_basis(order, b[0], b[1], b[2]);
  double sum = 0;
  for (int n = 0; n < kNodesPerTriangle; ++n) {
    sum += basis[n] * f(kNodeBarycentric[n][1], kNodeBarycentric[n][2]);
  }
  return sum;
}

TEST(PatchNodes, near_and_far_ones_lie_thirds_along_their_edge) {
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    EXPECT_EQ(kNodeBarycentric[near_node(k)][k], 2.0 / 3);
    EXPECT_EQ(kNodeBarycentric[near_node(k)][next], 1.0 / 3);
    EXPECT_EQ(kNodeBarycentric[far_node(k)][k], 1.0 / 3);
    EXPECT_EQ(kNodeBarycentric[far_node(k)][next], 2.0 / 3);
    EXPECT_EQ(edge_node(k, next), near_node(k));
    EXPECT_EQ(edge_node(next, k), far_node(k));
    EXPECT_EQ(kNodeBarycentric[kCenterNode][k], 1.0 / 3);
  }
}

TEST(Patch, the_basis_sums_to_one) {
  std::mt19937 random(1);
  for (PatchOrder order : kOrders) {
    for (int i = 0; i < 1000; ++i) {
      const auto b = random_barycentric(random);
      const auto basis = patch_basis(order, b[0], b[1], b[2]);
      EXPECT_NEAR(std::accumulate(basis.begin(), basis.end(), 0.0), 1, 1e-12);
    }
  }
}

TEST(Patch, the_cubic_takes_its_value_at_every_node) {
  for (int n = 0; n < kNodesPerTriangle; ++n) {
    const auto& b = kNodeBarycentric[n];
    const auto basis = patch_basis(PatchOrder::cubic, b[0], b[1], b[2]);
    for (int m = 0; m < kNodesPerTriangle; ++m) EXPECT_NEAR(basis[m], m == n ? 1 : 0, 1e-12);
  }
}

TEST(Patch, each_order_reproduces_polynomials_of_its_degree) {
  std::mt19937 random(2);
  const auto line = [](double u, double v) { return 1 - 2 * u + 3 * v; };
  const auto parabola = [&](double u, double v) {
    return line(u, v) + u * u - 4 * u * v + 2 * v * v;
  };
  const auto cubic = [&](double u, double v) {
    return parabola(u, v) + 3 * u * u * u - u * u * v + 5 * u * v * v - 2 * v * v * v;
  };
  for (int i = 0; i < 1000; ++i) {
    const auto b = random_barycentric(random);
    EXPECT_NEAR(interpolate(PatchOrder::linear, b, line), line(b[1], b[2]), 1e-12);
    EXPECT_NEAR(interpolate(PatchOrder::quadratic, b, parabola), parabola(b[1], b[2]), 1e-12);
    EXPECT_NEAR(interpolate(PatchOrder::cubic, b, cubic), cubic(b[1], b[2]), 1e-12);
  }
}

TEST(Patch, turn_angle_agrees_with_the_library) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 10'000; ++i) {
    const Vec2 a{normal(random), normal(random)}, b{normal(random), normal(random)};
    double expected = std::atan2(cross(a, b), dot(a, b));
    if (expected < 0) expected += 2 * std::numbers::pi;
    EXPECT_NEAR(solve::turn_angle(a, b), expected, 1e-7);
  }
  EXPECT_EQ(solve::turn_angle({1, 0}, {1, 0}), 0);
  EXPECT_NEAR(solve::turn_angle({1, 0}, {-1, 0}), std::numbers::pi, 1e-12);
  EXPECT_EQ(solve::turn_angle({0, 0}, {1, 0}), 0);
}

}  // namespace
}  // namespace sfumato
