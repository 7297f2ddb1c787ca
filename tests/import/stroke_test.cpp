// Outlines of strokes: what they cost, and what they hold where a stroke is wide.
#include <gtest/gtest.h>

#include "import/stroke_outline.hpp"
#include "support/poll_recorder.hpp"

namespace sfumato {
namespace {

using svg_import::Contours;

constexpr double kTolerance = 100.0 / 16384;

/// A subpath of loops that end in cusps.
Contours curls(int count) {
  std::vector<Vec2> path{{50, 50}};
  for (int i = 0; i < count; ++i) path.insert(path.end(), {{59, 50}, {41, 59}, {50, 50}});
  return {path};
}

TEST(StrokeOutline, charges_its_points_for_as_long_as_they_live) {
  Context context;
  {
    ScopedCharge charge;
    const auto outline =
        svg_import::stroke_outline(context, curls(1000), {.width = 2}, kTolerance, &charge);
    ASSERT_TRUE(outline);
    std::size_t points = 0;
    for (const auto& contour : *outline) points += contour.size();
    EXPECT_GE(context.budget.used(), points * sizeof(Vec2));
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(StrokeOutline, ends_at_the_memory_limit) {
  for (const std::vector<double>& dashes : {std::vector<double>{}, {1, 1}}) {
    Context context{.budget = Budget(1'000'000)};
    const StrokeStyle style{.width = 2, .dashes = dashes};
    const auto outline = svg_import::stroke_outline(context, curls(1000), style, kTolerance);
    ASSERT_FALSE(outline);
    EXPECT_EQ(outline.status().code, StatusCode::limit);
  }
}

TEST(StrokeOutline, of_one_long_subpath_looks_at_the_flag) {
  for (const std::vector<double>& dashes : {std::vector<double>{}, {1, 1}}) {
    Context context;
    test::PollRecorder polls;
    context.poll_watch = &polls;
    const StrokeStyle style{.width = 2, .dashes = dashes};
    ASSERT_TRUE(svg_import::stroke_outline(context, curls(1000), style, kTolerance));
    EXPECT_GE(polls.polls(), 1000u);
  }
}

TEST(StrokeOutline, far_from_the_origin_is_as_exact_as_its_coordinates) {
  Context context;
  std::vector<Vec2> path = curls(1)[0];
  for (Vec2& p : path) p = p + Vec2{1e7, 1e7};
  const auto outline = svg_import::stroke_outline(context, {path}, {.width = 2}, 1e-12);
  ASSERT_TRUE(outline);
  EXPECT_LT(outline->at(0).size(), 3000u);
}

}  // namespace
}  // namespace sfumato
