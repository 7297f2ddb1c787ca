#include <gtest/gtest.h>

#include "lint/hints.hpp"
#include "support/drawing.hpp"

/// Typical mistakes of beginners: seams, open sides, crossing curves, ends that miss.
namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::count;
using test::hints_of;
using test::kBlack;
using test::kBlue;
using test::kGreen;
using test::kMiddle;
using test::kRed;
using test::kWhite;
using test::of_kind;
using test::one_color;
using test::one_layer;
using test::one_opacity;
using test::straight_curve;

SideShader<Rgb> stops(std::vector<Stop<Rgb>> list) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, std::move(list)}, 0};
}

/// Returns a circle with colours inside that change from one to the other.
Curve shaded_circle(Rgb first, Rgb last) {
  Curve curve = colored(circle_curve(kMiddle, 30), kBlue, kBlue);
  curve.right.color = stops({{0, first}, {1, last}});
  return curve;
}

/// Returns a curve that is closed at a corner.
Curve drop(Rgb first, Rgb last) {
  Curve curve{
      .control_points = {{50, 10}, {90, 40}, {80, 90}, {50, 90}, {20, 90}, {10, 40}, {50, 10}}};
  curve.left.color = one_color(kBlue);
  curve.right.color = stops({{0, first}, {2, last}});
  return curve;
}

Curve line(Vec2 from, Vec2 to) {
  return colored(straight_curve(from, to), kWhite, kBlack);
}

TEST(LintSeam, a_closed_curve_whose_first_and_last_colours_differ) {
  const auto found = of_kind(hints_of(one_layer({shaded_circle(kRed, kGreen)})), HintKind::seam);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].curve, 0u);
  EXPECT_EQ(found[0].side, CurveSide::right);
  EXPECT_NE(
      found[0].message.find("begin with #ff0000 and end with #00ff00: a seam shows at 80, 50"),
      std::string::npos)
      << found[0].message;
  Curve both = shaded_circle(kRed, kGreen);
  both.left.color = both.right.color;
  EXPECT_EQ(found[0].at, Vec2(80.0, 50.0));
  EXPECT_EQ(count(one_layer({both}), HintKind::seam), 2u);
}

TEST(LintSeam, not_where_the_colours_are_the_same_again) {
  Curve curve = shaded_circle(kRed, kRed);
  EXPECT_EQ(count(one_layer({curve}), HintKind::seam), 0u);
  curve.right.color = stops({{0, kRed}, {2, kGreen}, {4, kRed}});
  EXPECT_EQ(count(one_layer({curve}), HintKind::seam), 0u);
  curve.right.color = one_color(kRed);
  EXPECT_EQ(count(one_layer({curve}), HintKind::seam), 0u);
}

TEST(LintSeam, not_where_they_differ_by_no_more_than_shading) {
  const auto grey = [](int code) {
    const float value = static_cast<float>(code) / 255;
    return Rgb{value, value, value};
  };
  EXPECT_EQ(count(one_layer({shaded_circle(grey(100), grey(124))}), HintKind::seam), 0u);
  EXPECT_EQ(count(one_layer({shaded_circle(grey(100), grey(126))}), HintKind::seam), 1u);
}

TEST(LintSeam, not_at_a_corner_nor_on_an_open_curve) {
  EXPECT_EQ(count(one_layer({drop(kRed, kGreen)}), HintKind::seam), 0u);
  Curve open = shaded_circle(kRed, kGreen);
  open.control_points.back() = {80, 45};
  EXPECT_EQ(count(one_layer({open}), HintKind::seam), 0u);
}

TEST(LintSeam, of_curves_of_which_all_points_are_one) {
  Curve dot{.control_points = {kMiddle, kMiddle, kMiddle, kMiddle}};
  dot.right.color = stops({{0, kRed}, {1, kGreen}});
  EXPECT_EQ(count(one_layer({dot, shaded_circle(kRed, kRed)}), HintKind::seam), 0u);
}

TEST(LintFlood, a_shape_whose_outside_is_open) {
  Curve disc = circle_curve(kMiddle, 30);
  disc.right.color = one_color(kRed);
  const auto found = of_kind(hints_of(one_layer({disc})), HintKind::flood);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].layer, 0u);
  EXPECT_EQ(found[0].stack_item, 0u);
  // Its colour only outside leaves the inside empty instead.
  std::swap(disc.left, disc.right);
  EXPECT_EQ(count(one_layer({disc}), HintKind::flood), 0u);
  EXPECT_EQ(count(one_layer({disc}), HintKind::inside_empty), 1u);
}

TEST(LintFlood, not_with_a_colour_or_nothing_outside) {
  Curve disc = circle_curve(kMiddle, 30);
  disc.right.color = one_color(kRed);
  disc.left.color.kind = ShaderKind::barrier;
  EXPECT_EQ(count(one_layer({disc}), HintKind::flood), 0u);
  disc.left.color = one_color(kBlue);
  EXPECT_EQ(count(one_layer({disc}), HintKind::flood), 0u);
}

TEST(LintFlood, not_where_something_else_ends_the_colour) {
  Curve disc = circle_curve(kMiddle, 30);
  disc.right.color = one_color(kRed);
  // A ground of two colours is a drawing in itself.
  EXPECT_EQ(count(one_layer({disc, colored(straight_curve({-9, 90}, {109, 90}), kRed, kBlue)}),
                  HintKind::flood),
            0u);
  // Opacity makes the outside transparent.
  disc.left.opacity = test::one_opacity(0);
  disc.right.opacity = test::one_opacity(1);
  EXPECT_EQ(count(one_layer({disc}), HintKind::flood), 0u);
}

TEST(LintFlood, with_shapes_within_the_one_that_is_open) {
  Curve face = circle_curve(kMiddle, 30);
  face.right.color = one_color(kRed);
  const Curve eye = colored(circle_curve({45, 45}, 5), kRed, kBlack);
  const Curve mouth = colored(straight_curve({40, 62}, {60, 62}), kRed, kBlack);
  const auto floods = [](const Document& document) { return count(document, HintKind::flood); };
  EXPECT_EQ(floods(one_layer({face, eye})), 1u);
  EXPECT_EQ(floods(one_layer({eye, mouth, face})), 1u);
  // A similar shape, and a guide without colours.
  Curve ball = circle_curve({10, 10}, 5);
  ball.right.color = one_color(kGreen);
  EXPECT_EQ(floods(one_layer({ball, face, straight_curve({0, 95}, {99, 95})})), 1u);
  // A shape beside it with colours outside is a ground.
  EXPECT_EQ(floods(one_layer({face, colored(circle_curve({10, 10}, 5), kRed, kBlack)})), 0u);
  Curve frame = circle_curve(kMiddle, 200);
  frame.right.color = one_color(kGreen);
  EXPECT_EQ(floods(one_layer({frame, eye, mouth})), 0u);
  face.left.color = one_color(kBlue);
  EXPECT_EQ(floods(one_layer({face, eye})), 0u);
}

TEST(LintFlood, above_something_it_is_a_leak) {
  Curve disc = circle_curve(kMiddle, 30);
  disc.right.color = one_color(kRed);
  Document document = one_layer({colored(straight_curve({-9, 90}, {109, 90}), kRed, kBlue)});
  document.layers.push_back({"disc", {disc}});
  LayerInstance instance;
  instance.layer = 1;
  document.stack.push_back(instance);
  EXPECT_EQ(count(document, HintKind::flood), 0u);
  EXPECT_EQ(count(document, HintKind::leak), 1u);
}

/// Returns a closed curve of two loops side by side that crosses itself in the middle.
Curve eight() {
  return {.control_points = {{50, 50},
                             {80, 10},
                             {95, 30},
                             {95, 50},
                             {95, 70},
                             {80, 90},
                             {50, 50},
                             {20, 10},
                             {5, 30},
                             {5, 50},
                             {5, 70},
                             {20, 90},
                             {50, 50}}};
}

/// Returns the corners of a star, or of another polygon.
Curve polygon(const std::vector<Vec2>& corners) {
  Curve curve{.control_points = {corners.front()}};
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const Vec2 from = corners[i - 1], to = corners[i % corners.size()];
    for (const double share : {1.0 / 3, 2.0 / 3, 1.0}) {
      curve.control_points.push_back(share == 1.0 ? to : lerp(from, to, share));
    }
  }
  return curve;
}

TEST(LintCrossing, an_eight_whose_sides_both_lie_outside) {
  const auto crossings = [](const Curve& curve) {
    return of_kind(hints_of(one_layer({curve})), HintKind::crossing);
  };
  Curve one_sided = eight();
  one_sided.left.color = one_color(kRed);
  const auto found = crossings(one_sided);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].message.find("crosses itself at 50, 50"), std::string::npos)
      << found[0].message;
  EXPECT_EQ(crossings(colored(eight(), kRed, kBlue)).size(), 1u);
  EXPECT_EQ(crossings(colored(eight(), kRed, kRed)).size(), 0u);
  EXPECT_EQ(crossings(eight()).size(), 0u);
  Curve bow = polygon({{10, 10}, {90, 91}, {90, 10}, {10, 91}});
  bow.right.color = one_color(kRed);
  EXPECT_EQ(crossings(bow).size(), 1u);
}

Curve with_opacities(Curve curve, float left, float right) {
  curve.left.opacity = one_opacity(left);
  curve.right.opacity = one_opacity(right);
  return curve;
}

TEST(LintCrossing, an_eight_of_one_colour_and_two_opacities) {
  const Curve red = colored(eight(), kRed, kRed);
  const auto found = of_kind(hints_of(one_layer({with_opacities(red, 0, 1)})), HintKind::crossing);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].at, (Vec2{50, 50}));
  EXPECT_EQ(count(one_layer({with_opacities(red, 1, 1)}), HintKind::crossing), 0u);
  Curve one_sided = red;
  one_sided.right.opacity = one_opacity(1);
  EXPECT_EQ(count(one_layer({one_sided}), HintKind::crossing), 1u);
}

/// An earlier output of the import: a leaf whose outline crosses itself beside its tip.
TEST(LintCrossing, a_leaf_that_is_twisted_at_its_tip) {
  const Curve leaf{.control_points = {{75.069, 67.659},
                                      {94.921, 76.533},
                                      {144.124, 103.604},
                                      {152.011, 111.383},
                                      {141.292, 108.588},
                                      {95.118, 76.079},
                                      {75.069, 67.659}}};
  Document document = one_layer({with_opacities(colored(leaf, kRed, kRed), 0, 1)});
  document.artboard = {{0, 0}, {200, 200}};
  EXPECT_EQ(count(document, HintKind::crossing), 1u);
}

TEST(LintCrossing, not_a_star_nor_a_loop_within) {
  Curve star = polygon({{50, 5}, {78, 90}, {5, 37}, {95, 37}, {22, 90}});
  EXPECT_EQ(count(one_layer({with_opacities(colored(star, kRed, kRed), 0, 1)}), HintKind::crossing),
            0u);
  star.right.color = one_color(kRed);
  EXPECT_EQ(count(one_layer({star}), HintKind::crossing), 0u);
  EXPECT_EQ(count(one_layer({colored(star, kRed, kBlue)}), HintKind::crossing), 0u);
}

TEST(LintCrossing, a_shape_that_passes_through_another) {
  const Curve ball = colored(circle_curve({40, 50}, 20), kBlue, kRed);
  const Curve shadow = colored(circle_curve({60, 50}, 20), kBlue, kBlack);
  const auto found = of_kind(hints_of(one_layer({ball, shadow})), HintKind::crossing);
  ASSERT_EQ(found.size(), 2u);  // in both places
  EXPECT_EQ(found[0].curve, 1u);
  EXPECT_NE(found[0].message.find("crosses curve 0 at 50, "), std::string::npos)
      << found[0].message;
}

TEST(LintCrossing, a_line_through_a_shape) {
  const Curve ball = colored(circle_curve(kMiddle, 20), kBlue, kRed);
  EXPECT_EQ(count(one_layer({ball, line({50, 50}, {95, 52})}), HintKind::crossing), 1u);
  EXPECT_EQ(count(one_layer({line({5, 50}, {95, 52}), ball}), HintKind::crossing), 2u);
}

TEST(LintCrossing, not_of_curves_apart_or_that_touch) {
  const Curve ball = colored(circle_curve({30, 50}, 20), kBlue, kRed);
  EXPECT_EQ(count(one_layer({ball, colored(circle_curve({75, 50}, 20), kBlue, kBlack)}),
                  HintKind::crossing),
            0u);
  EXPECT_EQ(count(one_layer({ball, colored(circle_curve({70, 50}, 20), kBlue, kBlack)}),
                  HintKind::crossing),
            0u)
      << "they touch at one point";
  EXPECT_EQ(count(one_layer({ball, line({50, 50}, {95, 50})}), HintKind::crossing), 0u)
      << "it ends on the shape";
}

TEST(LintCrossing, not_in_layers_of_their_own) {
  Document document = one_layer({colored(circle_curve({40, 50}, 20), kBlue, kRed)});
  document.layers.push_back({"shadow", {colored(circle_curve({60, 50}, 20), kBlue, kBlack)}});
  LayerInstance instance;
  instance.layer = 1;
  document.stack.push_back(instance);
  EXPECT_EQ(count(document, HintKind::crossing), 0u);
}

TEST(LintCrossing, not_where_the_colours_fit_nor_of_open_strokes) {
  // The line's colours change where it passes the shape: red inside, blue outside.
  Curve fitting = straight_curve({20, 50.5}, {100, 50.5});
  fitting.left.color = stops({{0, kRed}, {0.625f, kRed}, {0.625f, kBlue}, {1, kBlue}});
  fitting.right.color = fitting.left.color;
  Curve square{.control_points = {{70, 80}}};
  for (const Vec2 corner : {Vec2{10, 80}, Vec2{10, 20}, Vec2{70, 20}, Vec2{70, 80}}) {
    const Vec2 from = square.control_points.back();
    for (const double t : {1.0 / 3, 2.0 / 3, 1.0}) {
      square.control_points.push_back(lerp(from, corner, t));
    }
  }
  square = colored(square, kBlue, kRed);
  EXPECT_EQ(count(one_layer({square, fitting}), HintKind::crossing), 0u);
  EXPECT_EQ(count(one_layer({square, line({20, 50.5}, {100, 50.5})}), HintKind::crossing), 1u);
  EXPECT_EQ(
      count(one_layer({line({10, 10}, {90, 90}), line({10, 90}, {90, 10})}), HintKind::crossing),
      0u);
}

TEST(LintGap, an_end_that_stops_shortly_before_a_curve) {
  // A pixel of an artboard 512 pixels long: 0.195 here.
  const Curve wall = line({50, 10}, {50, 90});
  const auto found =
      of_kind(hints_of(one_layer({wall, line({10, 50}, {49.5, 50})})), HintKind::gap);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].curve, 1u);
  EXPECT_NE(found[0].message.find("its end at 49.5, 50 stops 0.5 units before curve 0"),
            std::string::npos)
      << found[0].message;
}

TEST(LintGap, two_ends_that_nearly_meet) {
  EXPECT_EQ(
      count(one_layer({line({10, 50}, {49.8, 50}), line({50.2, 50}, {90, 50})}), HintKind::gap),
      2u);
}

TEST(LintGap, an_outline_of_two_curves_that_nearly_meet) {
  Curve upper{.control_points = {{20, 50}, {20, 10}, {80, 10}, {80, 50}}};
  Curve lower{.control_points = {{80, 50.4}, {80, 90}, {20, 90}, {20, 50}}};
  upper = colored(upper, kBlue, kRed), lower = colored(lower, kBlue, kRed);
  EXPECT_EQ(count(one_layer({upper, lower}), HintKind::gap), 2u);
  lower.control_points[0] = {80, 50};
  EXPECT_EQ(count(one_layer({upper, lower}), HintKind::gap), 0u);
}

TEST(LintGap, not_where_an_end_meets_the_curve_or_keeps_away_from_it) {
  const Curve wall = line({50, 10}, {50, 90});
  EXPECT_EQ(count(one_layer({wall, line({10, 50}, {50, 50})}), HintKind::gap), 0u);
  EXPECT_EQ(count(one_layer({wall, line({10, 50}, {49, 50})}), HintKind::gap), 0u);
}

TEST(LintGap, not_where_the_end_points_past_the_curve_or_hardly_has_two_colours) {
  const Curve wall = line({50, 10}, {50, 90});
  EXPECT_EQ(count(one_layer({wall, line({49.5, 20}, {49.5, 50})}), HintKind::gap), 0u);
  const Rgb grey{0.4f, 0.4f, 0.4f};
  EXPECT_EQ(count(one_layer({wall, colored(straight_curve({10, 50}, {49.5, 50}), kBlack, grey)}),
                  HintKind::gap),
            1u);
  const Rgb dark{0.37f, 0.37f, 0.37f};  // 94 code values
  EXPECT_EQ(count(one_layer({wall, colored(straight_curve({10, 50}, {49.5, 50}), kBlack, dark)}),
                  HintKind::gap),
            0u);
}

TEST(LintOvershoot, an_end_that_sticks_out_beyond_a_curve) {
  const Curve wall = line({50, 10}, {50, 90});
  const auto found =
      of_kind(hints_of(one_layer({wall, line({10, 50}, {50.5, 50})})), HintKind::overshoot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].curve, 1u);
  EXPECT_NE(found[0].message.find("its end at 50.5, 50 lies 0.5 units beyond a curve"),
            std::string::npos)
      << found[0].message;
  EXPECT_EQ(count(one_layer({wall, line({10, 50}, {52, 50})}), HintKind::overshoot), 0u);
  EXPECT_EQ(count(one_layer({wall, line({50, 50}, {50.5, 50})}), HintKind::overshoot), 0u)
      << "a short curve that begins there";
}

TEST(LintOvershoot, not_of_an_end_behind_a_corner_of_its_own) {
  Curve hook = line({10, 50}, {50, 50});
  const Curve tip = line({50, 50}, {50.2, 50.4});
  hook.control_points.insert(hook.control_points.end(), tip.control_points.begin() + 1,
                             tip.control_points.end());
  EXPECT_EQ(count(one_layer({hook}), HintKind::overshoot), 0u);
  EXPECT_EQ(count(one_layer({hook}), HintKind::gap), 0u);
}

TEST(LintGap, many_are_told_as_one) {
  std::vector<Curve> curves{line({50, 0}, {50, 100})};
  for (int i = 0; i < 40; ++i) {
    curves.push_back(line({20, 2.5 * i + 1}, {49.5, 2.5 * i + 1}));
  }
  const auto found = of_kind(hints_of(one_layer(curves)), HintKind::gap);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].layer, 0u);
  EXPECT_FALSE(found[0].curve.has_value());
  EXPECT_EQ(found[0].message.find("40 ends that stop shortly before another curve; curve "), 0u)
      << found[0].message;
}

}  // namespace
}  // namespace sfumato
