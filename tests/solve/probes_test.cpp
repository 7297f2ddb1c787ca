#include "solve/fields/probes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "picture/patch.hpp"

namespace sfumato::solve {
namespace {

constexpr double kCodeValues = 255;

/// Returns the predicted error of one triangle with ten separate nodes and one channel. `where`
/// receives the likely probes.
float foretold(const std::array<double, kNodesPerTriangle>& value, ProbeChoice* where = nullptr) {
  NodeLayout layout;
  layout.channel_count = 1;
  layout.triangle_node.resize(value.size());
  std::iota(layout.triangle_node.begin(), layout.triangle_node.end(), 0u);
  for (const double v : value) layout.value.push_back(static_cast<float>(v));
  float miss = 0;
  const ProbeChoice likely = foretell_miss(layout, 0, {}, &miss);
  if (where) *where = likely;
  return miss;
}

/// The inner probes and the edges' centres.
constexpr std::array<std::array<double, 3>, 6> kProbes{{{4.0 / 6, 1.0 / 6, 1.0 / 6},
                                                        {1.0 / 6, 4.0 / 6, 1.0 / 6},
                                                        {1.0 / 6, 1.0 / 6, 4.0 / 6},
                                                        {0.5, 0.5, 0},
                                                        {0, 0.5, 0.5},
                                                        {0.5, 0, 0.5}}};

double sum(const PatchBasis& basis, const std::array<double, kNodesPerTriangle>& value) {
  return std::inner_product(basis.begin(), basis.end(), value.begin(), 0.0);
}

TEST(ForetellMiss, is_five_times_what_the_cubic_adds_to_the_quadratic) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int run = 0; run < 200; ++run) {
    std::array<double, kNodesPerTriangle> value;
    for (double& v : value) v = unit(random);
    double most = 0;
    std::size_t corner = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [w, u, v] = kProbes[k];
      const double added = std::fabs(sum(patch_basis(PatchOrder::cubic, w, u, v), value) -
                                     sum(patch_basis(PatchOrder::quadratic, w, u, v), value));
      if (added > most) corner = k;
      most = std::max(most, added);
    }
    const auto [low, high] = std::ranges::minmax(value);
    ProbeChoice where = 0;
    EXPECT_NEAR(foretold(value, &where), std::max(5 * most, (high - low) / 24), 1e-5);
    EXPECT_EQ(where, 5 * most > (high - low) / 24 ? 1 << corner : kInnerProbes);
  }
}

TEST(ForetellMiss, of_a_quadratic_is_a_share_of_its_range) {
  std::array<double, kNodesPerTriangle> value;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const double x = kNodeBarycentric[i][1], y = kNodeBarycentric[i][2];
    value[i] = 0.2 + x * x - 0.3 * y * y + 0.1 * x * y;
  }
  const auto [low, high] = std::ranges::minmax(value);
  ProbeChoice where = 0;
  EXPECT_NEAR(foretold(value, &where), (high - low) / 24, 1e-6);
  EXPECT_EQ(where, kInnerProbes);
}

/// Returns the colour beside a straight edge that is blurred over radius 1 (eq. 8), at the distance
/// y.
double beside_edge(double y) {
  return y < 1 ? 1 - (1 - y) * (1 - y) * (2 + y) / 4 : 1;
}

TEST(ForetellMiss, is_no_less_than_the_miss_beside_a_blurred_edge) {
  // From the edge to the end of the patch, in either direction; smallest at the depth of 1.44
  // radii, where the nodes do not detect the break of the profile.
  for (double depth = 0.5; depth < 1.6; depth += 0.01) {
    for (const bool has_corner_at_edge : {false, true}) {
      const auto value_at = [&](const std::array<double, 3>& at) {
        return beside_edge(depth * (has_corner_at_edge ? 1 - at[0] : at[0]));
      };
      std::array<double, kNodesPerTriangle> value;
      std::ranges::transform(kNodeBarycentric, value.begin(), value_at);
      for (const auto& probe : kProbes) {
        const double miss =
            std::fabs(sum(patch_basis(PatchOrder::cubic, probe[0], probe[1], probe[2]), value) -
                      value_at(probe));
        EXPECT_LE(kCodeValues * miss, kCodeValues * foretold(value) + 0.1) << depth;
      }
    }
  }
}

}  // namespace
}  // namespace sfumato::solve
