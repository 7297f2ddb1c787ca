#include "sfumato/lint/lint.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lint/hints.hpp"
#include "support/drawing.hpp"

namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::count;
using test::hints_of;
using test::kBlue;
using test::kMiddle;
using test::kRed;
using test::of_kind;
using test::one_color;
using test::one_layer;
using test::one_opacity;
using test::straight_curve;

/// Returns all hints except notes, for messages.
std::string listed(const Document& document) {
  std::string text;
  for (const Hint& hint : hints_of(document)) {
    if (!is_note(hint.kind)) text += place_text(document, hint) + ": " + hint.message + '\n';
  }
  return text;
}

Curve reversed(Curve curve) {
  std::reverse(curve.control_points.begin(), curve.control_points.end());
  return curve;
}

ScalarStops one_radius(float value) {
  return {StopSpace::parameter, {{0, value}}};
}

/// Returns a disc: colour inside, and none outside.
Curve disc(Vec2 center, double radius) {
  Curve curve = colored(circle_curve(center, radius), kRed, kBlue);
  curve.left.opacity = one_opacity(0);
  curve.right.opacity = one_opacity(1);
  return curve;
}

LayerInstance instance_of(std::uint32_t layer) {
  LayerInstance instance;
  instance.layer = layer;
  return instance;
}

LocalStroke stroke_at(Vec2 from, Vec2 to) {
  LocalStroke stroke;
  stroke.curve.control_points = straight_curve(from, to).control_points;
  stroke.curve.left_color = {StopSpace::parameter, {{0, kRed}}};
  stroke.curve.influence_radius = one_radius(5);
  return stroke;
}

Shader gradient(std::size_t stop_count) {
  GradientFill fill;
  fill.stops.assign(stop_count, GradientStop{0, kRed, 1});
  return {"gradient", fill};
}

/// Returns a texture of 4 × 4 texels, each `texel` units wide.
Shader texture(double texel) {
  Texture paint;
  paint.width = paint.height = 4;
  paint.rgba.assign(64, 255);
  paint.layer_from_texture = {texel, 0, 0, texel, 0, 0};
  return {"texture", paint};
}

Document shaded(Shader shader) {
  Document document = one_layer({circle_curve(kMiddle, 30)});
  document.shaders.push_back(std::move(shader));
  document.layers[0].curves[0].right.color = {ShaderKind::image_domain, {}, 0};
  return document;
}

TEST(Lint, has_no_hints_on_a_sound_drawing) {
  Document document = one_layer({colored(circle_curve(kMiddle, 30), kRed, kBlue),
                                 colored(straight_curve({10, 90}, {90, 95}), kRed, kBlue)});
  document.layers.push_back({"disc", {disc(kMiddle, 10)}});
  document.stack.push_back(instance_of(1));
  document.stack.push_back(stroke_at({20, 20}, {40, 20}));
  EXPECT_EQ(listed(document), "");
}

TEST(Lint, finds_an_open_loop_that_looks_closed) {
  Curve loop = colored(circle_curve(kMiddle, 30), kRed, kBlue);
  loop.control_points.back() = loop.control_points.back() + Vec2{0, 0.5};
  const Document document = one_layer({loop});
  const std::vector<Hint> found = of_kind(hints_of(document), HintKind::open_loop);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(place_text(document, found[0]), "layer 0 \"layer\", curve 0");
  EXPECT_NE(found[0].message.find("0.5 units apart"), std::string::npos) << found[0].message;
}

TEST(Lint, takes_a_wide_gap_for_meant) {
  Curve share = circle_curve(kMiddle, 30);  // 188 long: 1% is below 4 pixels of 512 here
  share.control_points.back() = share.control_points.back() + Vec2{0, 2};
  EXPECT_EQ(count(one_layer({share}), HintKind::open_loop), 0u);
  Curve pixels = circle_curve(kMiddle, 49);  // 308 long
  pixels.control_points.back() = pixels.control_points.back() + Vec2{0, 1};
  EXPECT_EQ(count(one_layer({pixels}), HintKind::open_loop), 0u);
  EXPECT_EQ(count(one_layer({pixels}, {{0, 0}, {200, 200}}), HintKind::open_loop), 1u);
}

TEST(Lint, notes_which_side_of_a_loop_is_inside) {
  const Curve clockwise = colored(circle_curve(kMiddle, 30), kRed, kBlue);
  const auto right = of_kind(hints_of(one_layer({clockwise})), HintKind::closed_loop);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_TRUE(is_note(right[0].kind));
  EXPECT_EQ(right[0].message, "it is closed and clockwise: its inside is on the right");
  const auto left = of_kind(hints_of(one_layer({reversed(clockwise)})), HintKind::closed_loop);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].message, "it is closed and counter-clockwise: its inside is on the left");
}

TEST(Lint, finds_a_loop_that_bears_something_outside_only) {
  Curve loop = circle_curve(kMiddle, 30);
  loop.left.color = one_color(kRed);
  EXPECT_EQ(count(one_layer({loop}), HintKind::inside_empty), 1u);
  EXPECT_EQ(count(one_layer({reversed(loop)}), HintKind::inside_empty), 0u);
  loop.right.color.kind = ShaderKind::barrier;
  EXPECT_EQ(count(one_layer({loop}), HintKind::inside_empty), 0u);
}

TEST(Lint, finds_a_curve_without_attributes) {
  EXPECT_EQ(count(one_layer({circle_curve(kMiddle, 30)}), HintKind::no_attribute), 1u);
  Document document = one_layer({colored(circle_curve(kMiddle, 30), kRed, kBlue)});
  LocalStroke stroke = stroke_at({20, 20}, {40, 20});
  stroke.curve.left_color = {};
  document.stack.push_back(stroke);
  const std::vector<Hint> found = of_kind(hints_of(document), HintKind::no_attribute);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(place_text(document, found[0]), "local curve at stack item 1");
}

TEST(Lint, finds_curves_that_lie_on_one_another) {
  const Curve curve = colored(straight_curve({20, 50}, {80, 50}), kRed, kBlue);
  const std::vector<Hint> twice =
      of_kind(hints_of(one_layer({curve, reversed(curve)})), HintKind::duplicate);
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].curve, 1u);
  EXPECT_EQ(count(one_layer({curve, curve}), HintKind::duplicate), 1u);
  EXPECT_EQ(count(one_layer({curve, curve}), HintKind::unseen_side), 0u);
}

TEST(Lint, accepts_colour_and_opacity_on_two_curves_in_one_place) {
  const Curve color = colored(circle_curve(kMiddle, 30), kRed, kBlue);
  Curve opacity = circle_curve(kMiddle, 30);
  opacity.left.opacity = opacity.right.opacity = one_opacity(0.5f);
  EXPECT_EQ(listed(one_layer({color, opacity})), "");
}

TEST(Lint, finds_a_side_that_another_curve_covers) {
  const Curve part = colored(straight_curve({40, 50}, {60, 50}), kRed, kBlue);
  const Curve whole = colored(straight_curve({20, 50}, {80, 50}), kBlue, kRed);
  const auto below = of_kind(hints_of(one_layer({part, whole})), HintKind::unseen_side);
  ASSERT_EQ(below.size(), 2u);
  EXPECT_EQ(below[0].curve, 0u);
  EXPECT_EQ(below[0].side, CurveSide::left);
  EXPECT_EQ(below[1].side, CurveSide::right);
  EXPECT_EQ(count(one_layer({whole, part}), HintKind::unseen_side), 0u);
  Curve open_below = whole;
  open_below.right.color = {};
  EXPECT_EQ(count(one_layer({part, open_below}), HintKind::unseen_side), 1u);
}

TEST(Lint, finds_a_side_that_is_walled_off_from_the_artboard) {
  // A wall around the artboard, and a curve with one side on it, outside.
  const Curve wall = colored(circle_curve(kMiddle, 90), kRed, kBlue);
  const Curve beyond = colored(straight_curve({-100, 0}, {-100, 100}), kRed, kBlue);
  const auto found = of_kind(hints_of(one_layer({wall, beyond})), HintKind::unseen_side);
  EXPECT_EQ(found.size(), 3u);  // the wall's outside and both sides beyond
  Curve window = wall;
  window.left.color = window.right.color = {};
  EXPECT_EQ(count(one_layer({window, beyond}), HintKind::unseen_side), 0u);
}

TEST(Lint, takes_a_side_that_shows_through_blur_for_seen) {
  Curve wall = colored(circle_curve(kMiddle, 90), kRed, kBlue);
  EXPECT_EQ(count(one_layer({wall}), HintKind::unseen_side), 1u);
  wall.right.blur_radius = one_radius(4);
  EXPECT_EQ(count(one_layer({wall}), HintKind::unseen_side), 0u);
}

TEST(Lint, finds_a_curve_outside_the_artboard) {
  const Curve inside = colored(straight_curve({20, 50}, {80, 50}), kRed, kBlue);
  const Curve outside = colored(straight_curve({120, 50}, {180, 50}), kRed, kBlue);
  // Its control points' box meets the artboard, but the curve does not.
  const Curve around = colored(straight_curve({90, -30}, {130, 30}), kRed, kBlue);
  const auto found = of_kind(hints_of(one_layer({inside, outside, around})), HintKind::outside);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].curve, 1u);
  EXPECT_EQ(found[1].curve, 2u);
}

TEST(Lint, takes_a_curve_along_most_of_a_side_of_the_artboard_for_its_frame) {
  const Curve along = colored(straight_curve({-10, -20}, {110, -20}), kRed, kBlue);
  const Curve around = colored(circle_curve(kMiddle, 90), kRed, kBlue);
  EXPECT_EQ(count(one_layer({along}), HintKind::outside), 0u);
  EXPECT_EQ(count(one_layer({around}), HintKind::outside), 0u);
  const auto ground = [](double from) {
    return one_layer({colored(straight_curve({from, 120}, {300, 120}), kRed, kBlue)});
  };
  EXPECT_EQ(count(ground(40), HintKind::outside), 0u);
  EXPECT_EQ(count(ground(60), HintKind::outside), 1u);
}

TEST(Lint, looks_at_the_artboard_as_every_instance_shows_it) {
  Document document = one_layer({colored(straight_curve({120, 50}, {180, 50}), kRed, kBlue)});
  EXPECT_EQ(count(document, HintKind::outside), 1u);
  document.stack.push_back(LayerInstance{0, {1, 0, 0, 1, -100, 0}, 1, BlendMode::normal});
  EXPECT_EQ(count(document, HintKind::outside), 0u);
}

TEST(Lint, finds_a_local_curve_outside_the_artboard) {
  Document document = one_layer({colored(circle_curve(kMiddle, 30), kRed, kBlue)});
  document.stack.push_back(stroke_at({106, 0}, {106, 100}));
  EXPECT_EQ(count(document, HintKind::outside), 1u);
  document.stack.back() = stroke_at({104, 0}, {104, 100});
  EXPECT_EQ(count(document, HintKind::outside), 0u);
}

TEST(Lint, finds_blur_on_a_side_without_shader) {
  Curve curve = circle_curve(kMiddle, 30);
  curve.right.color = one_color(kRed);
  curve.left.blur_radius = one_radius(3);
  const auto found = of_kind(hints_of(one_layer({curve})), HintKind::blur_without_shader);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].side, CurveSide::left);
  curve.left.blur_radius = one_radius(0);
  EXPECT_EQ(count(one_layer({curve}), HintKind::blur_without_shader), 0u);
}

TEST(Lint, finds_opacity_in_a_layer_without_colour) {
  Curve curve = circle_curve(kMiddle, 30);
  curve.right.opacity = one_opacity(1);
  EXPECT_EQ(count(one_layer({curve}), HintKind::opacity_without_color), 1u);
  curve.right.color = one_color(kRed);
  EXPECT_EQ(count(one_layer({curve}), HintKind::opacity_without_color), 0u);
}

TEST(Lint, finds_layers_without_curves_and_layers_without_instances) {
  Document document = one_layer({});
  EXPECT_EQ(count(document, HintKind::empty_layer), 1u);
  document.stack.clear();
  EXPECT_EQ(count(document, HintKind::unused_layer), 1u);
}

TEST(Lint, finds_a_layer_that_covers_all_that_is_below) {
  const Curve ground = colored(straight_curve({-10, 50}, {110, 50}), kRed, kBlue);
  Curve leaking = colored(circle_curve(kMiddle, 20), kRed, kBlue);
  Document document = one_layer({ground});
  document.layers.push_back({"leaking", {leaking}});
  document.stack.push_back(instance_of(1));
  const std::vector<Hint> found = of_kind(hints_of(document), HintKind::leak);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].layer, 1u);
  EXPECT_EQ(found[0].stack_item, 1u);

  Curve& curve = document.layers[1].curves[0];
  curve.left.color.stops = {};
  curve.left.color.kind = ShaderKind::open;  // no colour outside: no leak
  EXPECT_EQ(count(document, HintKind::leak), 1u) << "its inside shows through the open side";
  curve.left.color.kind = ShaderKind::barrier;
  EXPECT_EQ(count(document, HintKind::leak), 0u);
  document.layers[1].curves[0] = disc(kMiddle, 20);
  EXPECT_EQ(count(document, HintKind::leak), 0u);
}

TEST(Lint, lets_the_lowest_layer_and_layers_that_leave_a_border_free_fill_the_artboard) {
  const Curve circle = colored(circle_curve(kMiddle, 20), kRed, kBlue);
  Document document = one_layer({circle});
  EXPECT_EQ(count(document, HintKind::leak), 0u);
  document.background = kRed;  // a picture's ground hides it on purpose
  EXPECT_EQ(count(document, HintKind::leak), 0u);
  Curve ground = straight_curve({-500, 50}, {600, 50});
  ground.right.color = one_color(kRed);
  ground.left.color.kind = ShaderKind::barrier;
  document.layers[0].curves[0] = ground;
  EXPECT_EQ(count(document, HintKind::leak), 0u);
}

TEST(Lint, lets_a_layer_frame_the_picture) {
  Document document = one_layer({colored(circle_curve(kMiddle, 20), kRed, kBlue)});
  Curve hole = disc(kMiddle, 30);
  std::swap(hole.left.opacity, hole.right.opacity);
  document.layers.push_back({"frame", {hole}});
  document.stack.push_back(instance_of(1));
  EXPECT_EQ(count(document, HintKind::leak), 0u);
}

TEST(Lint, finds_what_is_invisible) {
  Document document = one_layer({colored(circle_curve(kMiddle, 30), kRed, kBlue)});
  document.stack.push_back(LayerInstance{0, {}, 0, BlendMode::normal});
  document.stack.push_back(GroupBegin{0, BlendMode::normal});
  document.stack.push_back(GroupEnd{});
  LocalStroke stroke = stroke_at({20, 20}, {40, 20});
  stroke.curve.alpha = 0;
  document.stack.push_back(stroke);
  const std::vector<Hint> found = of_kind(hints_of(document), HintKind::invisible);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(place_text(document, found[0]), "stack item 1, layer 0 \"layer\"");
}

/// Returns a stroke of two colours over a sound drawing of 100 × 100 units.
Document with_stroke(float radius, float blur, Rgb right) {
  Document document = one_layer({colored(circle_curve(kMiddle, 30), kRed, kBlue)});
  LocalStroke stroke = stroke_at({20, 20}, {40, 20});
  stroke.curve.right_color = {StopSpace::parameter, {{0, right}}};
  stroke.curve.influence_radius = one_radius(radius);
  stroke.curve.blur_radius = one_radius(blur);
  document.stack.push_back(stroke);
  return document;
}

TEST(Lint, finds_local_curves_too_thin_to_be_seen) {
  // A pixel of 512 is 0.195 units.
  EXPECT_EQ(count(with_stroke(0.002f, 0, kRed), HintKind::stroke_radius), 0u);
  Document thin = with_stroke(0.001f, 0, kRed);
  const std::vector<Hint> found = of_kind(hints_of(thin), HintKind::stroke_radius);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(place_text(thin, found[0]), "local curve at stack item 1");
  EXPECT_NE(found[0].message.find("nowhere above 0.001 units"), std::string::npos)
      << found[0].message;
  std::get<LocalStroke>(thin.stack[1]).artboard_from_stroke = {4, 0, 0, 4, 0, 0};
  EXPECT_EQ(count(thin, HintKind::stroke_radius), 0u) << "enlarged";
}

TEST(Lint, finds_local_curves_that_cover_the_whole_picture) {
  EXPECT_EQ(count(with_stroke(140, 0, kRed), HintKind::stroke_radius), 0u);
  Document wide = with_stroke(150, 0, kRed);
  EXPECT_EQ(count(wide, HintKind::stroke_radius), 1u);
  std::get<LocalStroke>(wide.stack[1]).curve.influence_radius.stops.push_back({1, 20});
  EXPECT_EQ(count(wide, HintKind::stroke_radius), 0u) << "at one end only";
}

TEST(Lint, finds_a_blur_of_a_local_curve_that_mixes_nothing) {
  EXPECT_EQ(count(with_stroke(5, 2, kRed), HintKind::stroke_blur), 1u);
  EXPECT_EQ(count(with_stroke(5, 0, kRed), HintKind::stroke_blur), 0u);
  EXPECT_EQ(count(with_stroke(5, 2, kBlue), HintKind::stroke_blur), 0u);
}

TEST(Lint, finds_a_blur_of_a_local_curve_that_is_wider_than_its_radius) {
  EXPECT_EQ(count(with_stroke(5, 5, kBlue), HintKind::stroke_blur), 0u);
  Document wide = with_stroke(5, 6, kBlue);
  const std::vector<Hint> found = of_kind(hints_of(wide), HintKind::stroke_blur);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].message.find("its blur of 6 is wider than its radius of 5"), std::string::npos)
      << found[0].message;
  std::get<LocalStroke>(wide.stack[1]).curve.blur_radius.stops.push_back({1, 0});
  EXPECT_EQ(count(wide, HintKind::stroke_blur), 0u) << "at one end only";
}

TEST(Lint, finds_an_instance_outside_the_artboard) {
  Document document = one_layer({disc(kMiddle, 20)});
  document.stack.push_back(LayerInstance{0, {1, 0, 0, 1, 200, 0}, 1, BlendMode::normal});
  const std::vector<Hint> found = of_kind(hints_of(document), HintKind::instance_outside);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].stack_item, 1u);
}

TEST(Lint, finds_gradients_of_one_stop_and_shaders_that_nothing_uses) {
  Document document = shaded(gradient(1));
  EXPECT_EQ(count(document, HintKind::one_stop_gradient), 1u);
  EXPECT_EQ(count(shaded(gradient(2)), HintKind::one_stop_gradient), 0u);
  document.shaders.push_back(gradient(1));
  EXPECT_EQ(count(document, HintKind::one_stop_gradient), 1u);
  const std::vector<Hint> unused = of_kind(hints_of(document), HintKind::unused_shader);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(place_text(document, unused[0]), "shader 1 \"gradient\"");
}

TEST(Lint, finds_a_texture_that_is_much_larger_than_it_is_drawn) {
  // A pixel of 4096 is 100 / 4096 = 0.024 units.
  EXPECT_EQ(count(shaded(texture(0.02)), HintKind::large_texture), 0u);
  EXPECT_EQ(count(shaded(texture(0.01)), HintKind::large_texture), 1u);
  Document enlarged = shaded(texture(0.01));
  std::get<LayerInstance>(enlarged.stack[0]).artboard_from_layer = {2, 0, 0, 2, 0, 0};
  EXPECT_EQ(count(enlarged, HintKind::large_texture), 0u);
}

TEST(Lint, gives_back_what_is_wrong_with_an_invalid_document) {
  Document document = one_layer({circle_curve(kMiddle, 30)});
  document.stack.push_back(instance_of(7));
  Context context;
  EXPECT_EQ(lint(context, document).status().code, StatusCode::bad_input);
}

TEST(Lint, every_kind_has_a_name) {
  for (int i = 0; i <= static_cast<int>(HintKind::stroke_blur); ++i) {
    EXPECT_FALSE(hint_name(static_cast<HintKind>(i)).empty());
  }
  EXPECT_EQ(hint_name(HintKind::stroke_blur), "stroke-blur");
}

}  // namespace
}  // namespace sfumato
