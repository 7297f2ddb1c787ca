#include "gather/scene/share_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gather/rows/weight_class.hpp"

/// Bounds on weights, and on changes that are too small to matter.
namespace sfumato::gather {
namespace {

TEST(WeightClass, is_a_lower_bound_within_a_quarter_of_an_octave) {
  std::uint8_t last = 0;
  for (float weight = 1e-11f; weight < 1e6f; weight *= 1.01f) {
    const std::uint8_t known = weight_class(weight);
    EXPECT_GE(known, last);
    EXPECT_LE(least_weight(known), weight);
    EXPECT_GE(least_weight(known) * 1.26f, weight);
    last = known;
  }
}

TEST(WeightClass, of_nothing_and_of_what_is_out_of_range_promises_nothing) {
  EXPECT_EQ(weight_class(0), 0);
  EXPECT_EQ(weight_class(1e-30f), kUnknownWeight);
  EXPECT_EQ(weight_class(1e-42f), kUnknownWeight);
  EXPECT_EQ(least_weight(0), 0);
  EXPECT_EQ(least_weight(kUnknownWeight), 0);
  EXPECT_LE(least_weight(weight_class(3e38f)), 3e38f);
}

Result<ShareBound> bound_of_unit_segment(const Context& context, double weight, double most) {
  const std::vector<Vec2> polyline{{0, 0}, {1, 0}};
  return ShareBound::create(context, std::vector<ShareBound::Polyline>{polyline}, weight, most);
}

TEST(ShareBound, holds_from_the_distance_on_that_its_formula_gives) {
  const Context context;
  // Seen from a point at distance d from the bounding circle: Â = 1 / d³, and 2 Â <= 0.02 (W - Â).
  const auto bound = bound_of_unit_segment(context, 1, 0.02);
  ASSERT_TRUE(bound.ok());
  const double d = std::cbrt(2.02 / 0.02);
  EXPECT_TRUE(bound->holds_at({0.5, 0.5 + d * 1.001}, 1, 1));
  EXPECT_FALSE(bound->holds_at({0.5, 0.5 + d * 0.999}, 1, 1));
}

TEST(ShareBound, holds_nowhere_near_the_curve_nor_where_nothing_is_known) {
  const Context context;
  const auto bound = bound_of_unit_segment(context, 1, 0.02);
  ASSERT_TRUE(bound.ok());
  EXPECT_FALSE(bound->holds_at({0.5, 0.1}, 1e20f, 1));
  EXPECT_FALSE(bound->holds_at({0.5, 1e6}, 0, 1));
}

TEST(ShareBound, says_how_much_and_with_fewer_runs_no_less) {
  const Context context;
  std::vector<Vec2> polyline;
  for (int i = 0; i <= 400; ++i) polyline.push_back({0.25 * i, 10 * std::sin(0.1 * i)});
  for (const double most : {0.002, 0.02, 0.3}) {
    const auto fine =
        ShareBound::create(context, std::vector<ShareBound::Polyline>{polyline}, 2, most);
    const auto coarse =
        ShareBound::create(context, std::vector<ShareBound::Polyline>{polyline}, 2, most, 5);
    ASSERT_TRUE(fine.ok() && coarse.ok());
    int held = 0;
    for (double y = -400; y <= 400; y += 7) {
      const Vec2 p{60 - y, y};
      const double share = fine->share_at(p, 0.25f, 4);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, coarse->share_at(p, 0.25f, 4)) << y;
      if (std::fabs(share - most) < 1e-9 * most) continue;
      // The circle around the whole may give a worse bound than the runs; holds_at() uses both.
      if (share > most) continue;
      EXPECT_TRUE(fine->holds_at(p, 0.25f, 4)) << y;
      ++held;
    }
    EXPECT_GT(held, 0);
  }
  const auto bound =
      ShareBound::create(context, std::vector<ShareBound::Polyline>{polyline}, 2, 0.02);
  EXPECT_TRUE(std::isinf(bound->share_at({50, 0}, 1, 4))) << "among the curve's runs";
  EXPECT_TRUE(std::isinf(bound->share_at({50, 300}, 0, 4))) << "nothing is known";
}

TEST(ShareBound, asks_for_more_of_a_heavier_curve) {
  const Context context;
  const auto light = bound_of_unit_segment(context, 0.1, 0.02);
  const auto heavy = bound_of_unit_segment(context, 1, 0.02);
  const auto none = bound_of_unit_segment(context, 0.1, 0);
  ASSERT_TRUE(light.ok() && heavy.ok() && none.ok());
  const Vec2 p{0.5, 4.8};
  EXPECT_TRUE(light->holds_at(p, 1, 1));
  EXPECT_FALSE(heavy->holds_at(p, 1, 1));
  EXPECT_FALSE(none->holds_at(p, 1, 1));
}

}  // namespace
}  // namespace sfumato::gather
