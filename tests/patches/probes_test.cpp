#include "patches/probes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "patches/patch.hpp"

namespace sfumato::patches {
namespace {

constexpr std::size_t kChannels = 3;

/// Of one triangle whose ten nodes are its own.
NodeLayout layout_of(const std::vector<float>& value) {
  NodeLayout layout;
  layout.channel_count = kChannels;
  layout.triangle_node.resize(kNodesPerTriangle);
  std::iota(layout.triangle_node.begin(), layout.triangle_node.end(), 0u);
  layout.value = value;
  return layout;
}

/// The patch's two orders held against each other where the inner probes lie.
std::array<float, kChannels> difference_of_orders(const std::vector<float>& value) {
  std::array<float, kChannels> most{};
  for (std::size_t k = 0; k < 3; ++k) {
    double at[3] = {1.0 / 6, 1.0 / 6, 1.0 / 6};
    at[k] = 4.0 / 6;
    const PatchBasis cubic = patch_basis(PatchOrder::cubic, at[0], at[1], at[2]);
    const PatchBasis quadratic = patch_basis(PatchOrder::quadratic, at[0], at[1], at[2]);
    for (std::size_t c = 0; c < kChannels; ++c) {
      double sum = 0;
      for (std::size_t n = 0; n < cubic.size(); ++n)
        sum += (cubic[n] - quadratic[n]) * value[kChannels * n + c];
      most[c] = std::max(most[c], static_cast<float>(std::fabs(sum)));
    }
  }
  return most;
}

TEST(CubicPart, is_what_the_cubic_adds_to_the_quadratic) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int run = 0; run < 200; ++run) {
    std::vector<float> value(kChannels * kNodesPerTriangle);
    for (float& v : value) v = unit(random);
    float part[kChannels];
    cubic_part(layout_of(value), 0, part);
    const auto expected = difference_of_orders(value);
    for (std::size_t c = 0; c < kChannels; ++c) EXPECT_NEAR(part[c], expected[c], 1e-5f);
  }
}

TEST(CubicPart, of_a_quadratic_is_nothing) {
  std::vector<float> value;
  for (const auto& at : kNodeBarycentric) {
    const double x = at[1], y = at[2];
    for (const double v : {x * x - 0.3 * y, 0.5 + x * y, y * (1 - y)})
      value.push_back(static_cast<float>(v));
  }
  float part[kChannels];
  cubic_part(layout_of(value), 0, part);
  for (const float p : part) EXPECT_NEAR(p, 0, 1e-6f);
}

}  // namespace
}  // namespace sfumato::patches
