#include "curves/front_share.hpp"

#include <gtest/gtest.h>

namespace sfumato::curves {
namespace {

TEST(FrontShare, rises_from_a_half_on_the_curve_to_all_at_the_radius) {
  EXPECT_EQ(front_share(0.0, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(front_share(1.0, 2.0), 0.84375);
  EXPECT_EQ(front_share(2.0, 2.0), 1);
  EXPECT_EQ(front_share(3.0, 2.0), 1);
}

TEST(FrontShare, without_a_radius_the_front_side_has_all) {
  EXPECT_EQ(front_share(0.0, 0.0), 1);
  EXPECT_EQ(front_share(0.0f, 0.0f), 1);
}

TEST(FrontShare, its_slope_is_that_of_its_differences) {
  constexpr double kStep = 1e-6;
  EXPECT_NEAR((front_share(kStep, 1.0) - front_share(0.0, 1.0)) / kStep, kFrontShareSlope, 1e-6);
  for (const double x : {0.1, 0.4, 0.9}) {
    const double difference = smoothstep(x + kStep) - smoothstep(x - kStep);
    EXPECT_NEAR(difference / (2 * kStep), smoothstep_slope(x), 1e-6) << x;
  }
}

}  // namespace
}  // namespace sfumato::curves
