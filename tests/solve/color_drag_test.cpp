#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "picture/check_picture.hpp"
#include "sfumato/solve/solution.hpp"
#include "solve/diffused.hpp"
#include "support/cancel_at.hpp"
#include "support/drawing.hpp"
#include "support/same_document.hpp"
#include "support/same_picture.hpp"

/// Solutions in which a stop gets other values.
namespace sfumato {
namespace {

using test::blurred;
using test::circle_curve;
using test::colored;
using test::difference_of;
using test::diffused;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::straight_curve;
using test::with_opacity;

const StopPlace kFirstStop{0, 0, CurveSide::left, StopAttribute::color, 0};

/// Returns two curves that meet, a blurred one, and a second layer with opacities.
Document drawing() {
  Document document =
      test::one_layer({colored(straight_curve({10, 20}, {50, 40}), kRed, kBlue),
                       colored(straight_curve({50, 40}, {90, 25}), kRed, kBlue),
                       blurred(colored(circle_curve({50, 70}, 15), kGreen, kRed), 6)});
  document.layers[0].curves[0].left.color.stops.stops.push_back({1, kGreen});
  document.layers.push_back(
      {"second", {with_opacity(colored(circle_curve({30, 60}, 20), kBlue, kGreen), 0, 0.8f)}});
  document.stack.push_back(LayerInstance{1, {}});
  return document;
}

using Stops = std::vector<Stop<Rgb>>;

/// Returns the drawing with other stops on the first side.
Document with_stops(Stops stops) {
  Document document = drawing();
  document.layers[0].curves[0].left.color.stops.stops = std::move(stops);
  return document;
}

/// The paper's mesh, which is the same for all colours.
const DiffuseOptions kPaper{.max_error = 0};

class ColorDrag : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(solution.solve(context, kPaper).ok()); }

  void take_over(Document document) {
    ASSERT_TRUE(solution.apply(context, ReplaceDocument{std::move(document)}).ok());
    ASSERT_TRUE(solution.solve(context, kPaper).ok());
  }

  const Stops& stops() const {
    return solution.document().layers[0].curves[0].left.color.stops.stops;
  }

  static void expect_refused(const Status& status, const std::string& words) {
    EXPECT_EQ(status.code, StatusCode::bad_input);
    EXPECT_NE(status.message.find(words), std::string::npos) << status.message;
  }

  /// Returns the largest difference of the first layer's nodes from diffuse()'s, in code values.
  float farthest_from_exact() const {
    const Picture exact = diffused(solution.document(), kPaper);
    const PatchField &is = solution.picture().layers[0].color, &want = exact.layers[0].color;
    EXPECT_EQ(is.triangle_node.size(), want.triangle_node.size());
    if (is.triangle_node.size() != want.triangle_node.size()) return 255;
    float largest = 0;
    for (std::size_t i = 0; i < is.triangle_node.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::fabs(is.node_value[3 * is.triangle_node[i] + c] -
                                              want.node_value[3 * want.triangle_node[i] + c]));
      }
    }
    return 255 * largest;
  }

  Context context;
  Solution solution = std::move(*Solution::create(context, drawing()));
};

TEST_F(ColorDrag, shows_the_values_of_the_new_colour) {
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  for (const Rgb color : {kGreen, Rgb{0.2f, 0.4f, 0.9f}}) {
    ASSERT_TRUE(solution.color(context, color).ok());
    EXPECT_EQ(stops()[0].value, color);
    EXPECT_TRUE(picture::check_picture(context, solution.picture()).ok());
    EXPECT_LT(farthest_from_exact(), 0.05);
  }
}

/// Many thin specks: a solve estimates distant curves, but the response of its nodes to a stop does
/// not.
TEST_F(ColorDrag, among_specks_is_as_good_as_the_gather_there) {
  Document document = test::one_layer({colored(straight_curve({40, 45}, {60, 55}), kRed, kBlue)});
  std::uint32_t random = 1;
  const auto number = [&] {
    return 100 * ((random = 1664525 * random + 1013904223) >> 8) * 0x1p-24;
  };
  for (int i = 0; i < 600; ++i) {
    const double x = number(), y = number();
    document.layers[0].curves.push_back(
        colored(straight_curve({x, y}, {x + 0.002 * number(), y + 0.1}), kGreen, kBlue));
  }
  take_over(std::move(document));
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  for (const Rgb color : {kGreen, Rgb{1, 1, 1}}) {
    ASSERT_TRUE(solution.color(context, color).ok());
    EXPECT_LT(farthest_from_exact(), 1);
  }
}

TEST_F(ColorDrag, leaves_the_picture_of_diffuse_once_it_is_solved) {
  const DiffuseOptions fine{.max_error = 2};
  ASSERT_TRUE(solution.solve(context, fine).ok());
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  ASSERT_TRUE(solution.color(context, Rgb{0.5f, 0.25f, 0}).ok());
  ASSERT_TRUE(solution.solve(context, fine).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document(), fine)), "");
  EXPECT_TRUE(solution.color_response().empty());
  expect_refused(solution.color(context, kRed), "no stop is prepared");
}

TEST_F(ColorDrag, depends_on_the_value_alone) {
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  ASSERT_TRUE(solution.color(context, kBlue).ok());
  const Picture first = solution.picture();
  for (const Rgb color : {kGreen, Rgb{1, 1, 1}, kBlue}) {
    ASSERT_TRUE(solution.color(context, color).ok());
  }
  EXPECT_EQ(difference_of(solution.picture(), first), "");
}

TEST_F(ColorDrag, of_an_opacity_shows_what_was_invisible) {
  const StopPlace place{1, 0, CurveSide::left, StopAttribute::opacity, 0};
  const std::uint32_t before = solution.picture().layers[1].triangle_count();
  ASSERT_TRUE(solution.begin_color(context, place).ok());
  ASSERT_TRUE(solution.color(context, 1.0f).ok());
  EXPECT_GT(solution.picture().layers[1].triangle_count(), before);
  const PatchField& opacity = solution.picture().layers[1].opacity;
  EXPECT_EQ(opacity.channel_count, 1);
  EXPECT_GT(*std::ranges::max_element(opacity.node_value), 0.99f);
  EXPECT_TRUE(picture::check_picture(context, solution.picture()).ok());
  expect_refused(solution.color(context, kRed), "a colour for an opacity");
}

TEST_F(ColorDrag, of_a_whole_side_moves_all_its_stops) {
  StopPlace side = kFirstStop;
  side.index.reset();
  take_over(with_stops({{0, {0.5f, 0.25f, 0}}, {1, {0.25f, 0.5f, 0.5f}}}));
  ASSERT_TRUE(solution.begin_color(context, side).ok());
  ASSERT_TRUE(solution.color(context, Rgb{0.75f, 0.25f, 0.25f}).ok());
  EXPECT_EQ(stops(), (Stops{{0, {0.75f, 0.25f, 0.25f}}, {1, {0.5f, 0.5f, 0.75f}}}));
  expect_refused(solution.color(context, Rgb{0.5f, 0.25f, 0.75f}), "not within 0 to 1");
  EXPECT_EQ(stops(), (Stops{{0, {0.75f, 0.25f, 0.25f}}, {1, {0.5f, 0.5f, 0.75f}}}));
  EXPECT_LT(farthest_from_exact(), 0.05);
}

TEST_F(ColorDrag, lets_a_corner_of_equal_colours_part) {
  take_over(with_stops({{0, kRed}}));
  ASSERT_TRUE(solution.begin_color(context, {0, 1, CurveSide::left, StopAttribute::color, 0}).ok());
  ASSERT_TRUE(solution.color(context, Rgb{0.25f, 0.5f, 1}).ok());
  EXPECT_LT(farthest_from_exact(), 0.05);
  ASSERT_TRUE(solution.color(context, kRed).ok());
  EXPECT_LT(farthest_from_exact(), 0.05);
}

/// Its free ends count for both fields, which a solution combines.
TEST_F(ColorDrag, is_exact_beside_a_curve_whose_colours_are_equal_and_whose_opacities_are_not) {
  Document document = test::one_layer(
      {with_opacity(colored(straight_curve({30, 50}, {60, 50}), kRed, kRed), 0.2f, 0.8f),
       with_opacity(colored(circle_curve({50, 50}, 45), kGreen, kBlue), 1, 1)});
  take_over(std::move(document));
  ASSERT_TRUE(
      solution.begin_color(context, {0, 1, CurveSide::right, StopAttribute::color, 0}).ok());
  ASSERT_TRUE(solution.color(context, kBlue).ok());
  EXPECT_LT(farthest_from_exact(), 0.05);
  ASSERT_TRUE(solution.color(context, kGreen).ok());
  EXPECT_LT(farthest_from_exact(), 0.05);
}

TEST_F(ColorDrag, with_the_colour_as_it_was_leaves_the_layer_solved) {
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  ASSERT_TRUE(solution.color(context, stops()[0].value).ok());
  EXPECT_LT(farthest_from_exact(), 0.05);
  ASSERT_TRUE(solution.begin_color(context, {0, 2, CurveSide::left, StopAttribute::color, 0}).ok());
  DiffuseStats stats;
  ASSERT_TRUE(solution.solve(context, kPaper, &stats).ok());
  EXPECT_EQ(stats.curves, 0u);
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document(), kPaper)), "");
}

TEST_F(ColorDrag, tells_which_layer_is_new) {
  (void)solution.take_delta();
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  EXPECT_TRUE(solution.take_delta().empty());
  for (const Rgb color : {kBlue, kGreen}) {
    ASSERT_TRUE(solution.color(context, color).ok());
    const PictureDelta delta = solution.take_delta();
    EXPECT_FALSE(delta.frame);
    EXPECT_EQ(delta.layers, std::vector<std::uint32_t>{0});
  }
}

TEST_F(ColorDrag, has_a_factor_for_each_row_of_values) {
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  ASSERT_TRUE(solution.color(context, stops()[0].value).ok());
  const std::vector<float> before = solution.picture().layers[0].color.node_value;
  const std::vector<float> factor(solution.color_response().begin(),
                                  solution.color_response().end());
  ASSERT_EQ(3 * factor.size(), before.size());
  EXPECT_GT(*std::ranges::max_element(factor), 0.8f);
  EXPECT_EQ(*std::ranges::min_element(factor), 0);
  ASSERT_TRUE(solution.color(context, kBlue).ok());
  const std::vector<float>& after = solution.picture().layers[0].color.node_value;
  for (std::size_t i = 0; i < factor.size(); ++i) {
    ASSERT_FLOAT_EQ(after[3 * i + 2], before[3 * i + 2] + factor[i]) << i;
    ASSERT_FLOAT_EQ(after[3 * i], before[3 * i] - factor[i]) << i;
  }
}

TEST_F(ColorDrag, refuses_what_is_not_a_stop_or_not_solved) {
  const auto begin = [&](StopPlace place) { return solution.begin_color(context, place); };
  expect_refused(begin({2, 0, CurveSide::left, StopAttribute::color, 0}), "no such stop");
  expect_refused(begin({0, 3, CurveSide::left, StopAttribute::color, 0}), "no such stop");
  expect_refused(begin({0, 0, CurveSide::left, StopAttribute::color, 2}), "no such stop");
  expect_refused(begin({0, 0, CurveSide::left, StopAttribute::opacity, {}}), "no such stop");
  expect_refused(begin({0, 0, static_cast<CurveSide>(2), StopAttribute::color, 0}), "no such stop");
  expect_refused(begin({0, 0, CurveSide::left, static_cast<StopAttribute>(2), 0}), "no such stop");
  ASSERT_TRUE(begin(kFirstStop).ok());
  expect_refused(solution.color(context, 0.5f), "a colour for an opacity");
  expect_refused(solution.color(context, Rgb{0, 1.5f, 0}), "not within 0 to 1");
  ASSERT_TRUE(solution.color(context, kBlue).ok());
  const Curve curve = solution.document().layers[0].curves[0];
  ASSERT_TRUE(solution.apply(context, ReplaceCurve{0, 0, curve}).ok());
  expect_refused(begin(kFirstStop), "to be solved");
  expect_refused(solution.color(context, kBlue), "no stop is prepared");
  expect_refused(solution.begin_drag(context, 0, {0}), "to be solved");
}

TEST_F(ColorDrag, begins_at_a_layer_that_nothing_shows) {
  Document hidden = drawing();
  hidden.stack.pop_back();
  take_over(std::move(hidden));
  ASSERT_TRUE(solution.begin_color(context, {1, 0, CurveSide::left, StopAttribute::color, 0}).ok());
  EXPECT_TRUE(solution.color_response().empty());
  ASSERT_TRUE(solution.color(context, kRed).ok());
  EXPECT_EQ(solution.document().layers[1].curves[0].left.color.stops.stops[0].value, kRed);
  ASSERT_TRUE(solution.solve(context, kPaper).ok());
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document(), kPaper)), "");
}

TEST_F(ColorDrag, that_is_cancelled_leaves_document_and_picture) {
  for (const std::uint64_t at : {1u, 7u, 40u, 200u}) {
    Context hurried;
    test::CancelAt watch(at, hurried.cancel);
    hurried.poll_watch = &watch;
    const Picture before = solution.picture();
    const Status status = solution.begin_color(hurried, kFirstStop);
    EXPECT_TRUE(status.ok() || status.code == StatusCode::cancelled) << status.message;
    EXPECT_EQ(difference_of(solution.picture(), before), "");
    solution.end_drag();
  }
  ASSERT_TRUE(solution.begin_color(context, kFirstStop).ok());
  const Document document = solution.document();
  const Picture picture = solution.picture();
  Context stopped;
  stopped.cancel.store(true);
  EXPECT_EQ(solution.color(stopped, kBlue).code, StatusCode::cancelled);
  EXPECT_TRUE(test::same_document(solution.document(), document));
  EXPECT_EQ(difference_of(solution.picture(), picture), "");
  EXPECT_TRUE(solution.color(context, kBlue).ok());
}

TEST_F(ColorDrag, keeps_no_memory_beyond_its_end) {
  Context lender;
  ASSERT_TRUE(solution.begin_color(lender, kFirstStop).ok());
  EXPECT_GT(lender.budget.used(), 4 * solution.color_response().size());
  ASSERT_TRUE(solution.color(lender, kBlue).ok());
  ASSERT_TRUE(solution.color(lender, kGreen).ok());
  EXPECT_EQ(context.budget.used(), bytes_of(solution.document()) + bytes_of(solution.picture()));
  solution.end_drag();
  EXPECT_EQ(lender.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato
