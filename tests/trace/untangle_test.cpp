// Closed curves cross neither themselves nor curves with other colours.
#include "trace/curves/untangle.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sfumato::tracing {
namespace {

constexpr SideValue kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};

/// Returns a closed curve of straight pieces, black on its left and white on its right.
TracedCurve polygon(std::vector<Vec2> corners) {
  TracedCurve curve;
  corners.push_back(corners.front());
  curve.control_points.push_back(corners[0]);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (int third = 1; third <= 3; ++third) {
      curve.control_points.push_back(lerp(corners[i - 1], corners[i], third / 3.0));
    }
  }
  const auto end = static_cast<double>(corners.size() - 1);
  curve.side[0] = {{0, end}, {kBlack, kBlack}};
  curve.side[1] = {{0, end}, {kWhite, kWhite}};
  return curve;
}

TracedCurve line(Vec2 from, Vec2 to, SideValue left, SideValue right) {
  TracedCurve curve;
  curve.control_points = {from, lerp(from, to, 1 / 3.0), lerp(from, to, 2 / 3.0), to};
  curve.side[0] = {{0, 1}, {left, left}};
  curve.side[1] = {{0, 1}, {right, right}};
  return curve;
}

bool untangled(std::vector<TracedCurve>& curves) {
  Context context;
  const Result<bool> changed = untangle(context, 100, 100, curves);
  EXPECT_TRUE(changed.ok()) << to_string(changed.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return changed.ok() && *changed;
}

TEST(Untangle, leaves_what_does_not_cross_as_it_is) {
  std::vector<TracedCurve> curves{polygon({{20, 20}, {60, 20}, {60, 60}, {20, 60}}),
                                  line({70, 10}, {70, 90}, kBlack, kWhite)};
  const std::vector<TracedCurve> before = curves;
  EXPECT_FALSE(untangled(curves));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].control_points, before[0].control_points);
  EXPECT_EQ(curves[0].side[0].value, before[0].side[0].value);
}

TEST(Untangle, makes_an_eight_two_closed_curves) {
  std::vector<TracedCurve> curves{polygon({{20, 20}, {80, 70}, {80, 20}, {20, 75}})};
  const double whole = length_of(curves[0]);
  EXPECT_TRUE(untangled(curves));
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_NEAR(length_of(curves[0]) + length_of(curves[1]), whole, 0.5);
  for (const TracedCurve& curve : curves) {
    EXPECT_TRUE(is_closed(curve));
    EXPECT_EQ(stop_count(curve), 0u);
  }
  EXPECT_FALSE(untangled(curves));
}

TEST(Untangle, takes_a_small_loop_away) {
  std::vector<TracedCurve> curves{
      polygon({{20, 20}, {80, 20}, {80, 80}, {48, 80}, {48, 78}, {52, 78}, {52, 82}, {20, 82}})};
  EXPECT_TRUE(untangled(curves));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(is_closed(curves[0]));
  EXPECT_GT(length_of(curves[0]), 230);
  EXPECT_FALSE(untangled(curves));
}

TEST(Untangle, cuts_the_open_curve_where_colors_clash) {
  const TracedCurve square = polygon({{20, 20}, {60, 20}, {60, 60}, {20, 60}});
  std::vector<TracedCurve> curves{square, line({40, 5}, {40, 45}, kWhite, kBlack)};
  EXPECT_TRUE(untangled(curves));
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].control_points, square.control_points);
  EXPECT_NEAR(curves[1].control_points.back().y, 20, 0.05);
  EXPECT_NEAR(curves[2].control_points.front().y, 20, 0.05);
  EXPECT_NEAR(length_of(curves[2]), 25, 0.1);
}

TEST(Untangle, lets_colors_that_fit_cross) {
  TracedCurve square = polygon({{20, 20}, {60, 20}, {60, 60}, {20, 60}});
  for (SideStops& side : square.side) side.value = {kWhite, kWhite};
  std::vector<TracedCurve> curves{square, line({40, 5}, {40, 45}, kWhite, kWhite)};
  EXPECT_FALSE(untangled(curves));
  EXPECT_EQ(curves.size(), 2u);
}

TEST(Untangle, drops_the_double_of_an_outline) {
  std::vector<TracedCurve> curves{polygon({{20, 20}, {60, 20}, {60, 60}, {20, 60}}),
                                  line({25, 20.6}, {55, 19.4}, kWhite, kBlack)};
  EXPECT_TRUE(untangled(curves));
  EXPECT_EQ(curves.size(), 1u);
}

TEST(Untangle, says_when_it_is_cancelled_or_short_of_memory) {
  std::vector<TracedCurve> curves{polygon({{20, 20}, {80, 70}, {80, 20}, {20, 75}})};
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(untangle(cancelled, 100, 100, curves).status().code, StatusCode::cancelled);
  Context small{.budget = Budget(1000)};
  EXPECT_EQ(untangle(small, 100, 100, curves).status().code, StatusCode::limit);
  EXPECT_EQ(curves.size(), 1u);
}

}  // namespace
}  // namespace sfumato::tracing
