#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "sfumato/base/limits.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

Curve some_curve() {
  Curve curve;
  curve.control_points = {{10, 10}, {20, 10}, {30, 10}, {40, 10}, {50, 10}, {60, 20}, {70, 30}};
  for (Side* side : {&curve.left, &curve.right}) {
    side->color.kind = ShaderKind::curve_domain;
    side->color.stops.stops = {{0, {1, 0, 0}}, {0.5, {0, 1, 0}}, {2, {0, 0, 1}}};
    side->blur_radius.stops = {{0, 0}, {2, 5}};
  }
  curve.left.opacity.kind = ShaderKind::curve_domain;
  curve.left.opacity.stops = {StopSpace::arc_length, {{0, 1}, {1, 0.5f}}};
  return curve;
}

LocalStroke some_stroke() {
  LocalStroke stroke;
  stroke.curve.control_points = some_curve().control_points;
  stroke.curve.left_color.stops = {{0, {1, 1, 1}}};
  stroke.curve.right_color.stops = {{0, {0, 0, 0}}};
  stroke.curve.influence_radius.stops = {{0, 0}, {1, 3}};
  return stroke;
}

/// Returns a document with one of everything.
Document some_document() {
  Document document;
  document.artboard = {{0, 0}, {100, 50}};
  document.background = Rgb{1, 1, 1};
  document.shaders.push_back({"sky", GradientFill{RadialGradient{{0, 0}, {0.5, 0}, 1},
                                                  SpreadMethod::pad,
                                                  {},
                                                  {{0, {0, 0, 1}, 1}, {1, {1, 1, 1}, 0.5f}}}});
  document.shaders.push_back(
      {"wood", Texture{2, 1, std::vector<std::uint8_t>(8), {}, true, {}, {}}});
  document.layers.push_back({"paper", {some_curve(), some_curve()}});
  document.layers[0].curves[1].right.color = {ShaderKind::image_domain, {}, 1};
  document.stack = {LayerInstance{}, some_stroke()};
  return document;
}

TEST(Validate, accepts_a_document_that_holds_one_of_everything) {
  const Status status = validate(Context{}, some_document());
  EXPECT_TRUE(status.ok()) << to_string(status);
}

TEST(Validate, accepts_a_document_without_curves) {
  Document document;
  document.artboard = {{-5, -5}, {5, 5}};
  EXPECT_TRUE(validate(Context{}, document).ok());
}

struct Fault {
  const char* name;
  std::function<void(Document&)> make;
  const char* message;
};

class FaultyDocument : public testing::TestWithParam<Fault> {};

TEST_P(FaultyDocument, is_refused_with_the_place) {
  Document document = some_document();
  GetParam().make(document);
  const Status status = validate(Context{}, document);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.message, GetParam().message);
}

Curve& second_curve(Document& document) {
  return document.layers[0].curves[1];
}

LocalStroke& stroke_of(Document& document) {
  return std::get<LocalStroke>(document.stack[1]);
}

LayerInstance& instance_of(Document& document) {
  return std::get<LayerInstance>(document.stack[0]);
}

GradientFill& gradient_of(Document& document) {
  return std::get<GradientFill>(document.shaders[0].paint);
}

const Fault kFaults[] = {
    {"empty_artboard", [](Document& d) { d.artboard = {}; },
     "the artboard has no area or is out of range"},
    {"flat_artboard", [](Document& d) { d.artboard.max.y = d.artboard.min.y; },
     "the artboard has no area or is out of range"},
    {"huge_artboard", [](Document& d) { d.artboard.max.x = 1e308; },
     "the artboard has no area or is out of range"},
    {"size",
     [](Document& d) {
       d.size_px = Vec2{3, 0};
     },
     "the picture's size is not above 0"},
    {"size_without_end",
     [](Document& d) {
       d.size_px = Vec2{3, INFINITY};
     },
     "the picture's size is not above 0"},
    {"background", [](Document& d) { d.background->g = 2; }, "the background is not within 0 to 1"},
    {"no_control_points", [](Document& d) { second_curve(d).control_points.clear(); },
     "layer 0 \"paper\": curve 1: 0 control points; use 3n+1 (4, 7, 10, …)"},
    {"one_control_point", [](Document& d) { second_curve(d).control_points.resize(1); },
     "layer 0 \"paper\": curve 1: 1 control points; use 3n+1 (4, 7, 10, …)"},
    {"five_control_points", [](Document& d) { second_curve(d).control_points.resize(5); },
     "layer 0 \"paper\": curve 1: 5 control points; use 3n+1 (4, 7, 10, …)"},
    {"nan_coordinate", [](Document& d) { second_curve(d).control_points[3].y = kNan; },
     "layer 0 \"paper\": curve 1: control point 3 is not finite or beyond the largest coordinate"},
    {"far_coordinate", [](Document& d) { second_curve(d).control_points[6].x = -1.1e7; },
     "layer 0 \"paper\": curve 1: control point 6 is not finite or beyond the largest coordinate"},
    {"unsorted_stops", [](Document& d) { second_curve(d).left.color.stops.stops[2].offset = 0.4; },
     "layer 0 \"paper\": curve 1: left side: colour: stop 2 falls back"},
    {"stop_beyond_curve",
     [](Document& d) { second_curve(d).left.blur_radius.stops[1].offset = 2.1; },
     "layer 0 \"paper\": curve 1: left side: blur radius: stop 1 lies outside the curve"},
    {"stop_beyond_length",
     [](Document& d) { second_curve(d).left.opacity.stops.stops[1].offset = 1.1; },
     "layer 0 \"paper\": curve 1: left side: opacity: stop 1 lies outside the curve"},
    {"nan_offset", [](Document& d) { second_curve(d).right.blur_radius.stops[0].offset = kNan; },
     "layer 0 \"paper\": curve 1: right side: blur radius: stop 0 lies outside the curve"},
    {"negative_blur", [](Document& d) { second_curve(d).right.blur_radius.stops[0].value = -1; },
     "layer 0 \"paper\": curve 1: right side: blur radius: stop 0 has a value out of range"},
    {"colour_above_1",
     [](Document& d) { second_curve(d).left.color.stops.stops[0].value.b = 1.1f; },
     "layer 0 \"paper\": curve 1: left side: colour: stop 0 has a value out of range"},
    {"no_stops", [](Document& d) { second_curve(d).left.color.stops.stops.clear(); },
     "layer 0 \"paper\": curve 1: left side: colour: no stops"},
    {"stops_on_open_side", [](Document& d) { second_curve(d).left.color.kind = ShaderKind::open; },
     "layer 0 \"paper\": curve 1: left side: colour: stops on a side that takes none"},
    {"missing_shader", [](Document& d) { second_curve(d).right.color.shader = 2; },
     "layer 0 \"paper\": curve 1: right side: colour: there is no shader 2"},
    {"zero_weight", [](Document& d) { second_curve(d).weight = 0; },
     "layer 0 \"paper\": curve 1: the weight is not above 0 and finite"},
    {"nan_weight", [](Document& d) { second_curve(d).weight = kNan; },
     "layer 0 \"paper\": curve 1: the weight is not above 0 and finite"},
    {"missing_layer", [](Document& d) { instance_of(d).layer = 1; },
     "stack item 0: there is no layer 1"},
    {"flat_transform", [](Document& d) { instance_of(d).artboard_from_layer.a = 0; },
     "stack item 0: the transform cannot be inverted"},
    {"opacity", [](Document& d) { instance_of(d).opacity = -0.1f; },
     "stack item 0: the opacity is not within 0 to 1"},
    {"stroke_without_width",
     [](Document& d) { stroke_of(d).curve.influence_radius.stops[1].value = 0; },
     "stack item 1: the influence radius is nowhere above 0"},
    {"stroke_stop_order", [](Document& d) { stroke_of(d).curve.left_color.stops[0].offset = -1; },
     "stack item 1: left colour: stop 0 lies outside the curve"},
    {"gradient_without_stops", [](Document& d) { gradient_of(d).stops.clear(); },
     "shader 0 \"sky\": the gradient has no stops"},
    {"gradient_stop_order", [](Document& d) { gradient_of(d).stops[0].offset = 1.5; },
     "shader 0 \"sky\": a stop's offset is out of order"},
    {"negative_focal_radius",
     [](Document& d) { std::get<RadialGradient>(gradient_of(d).shape).focal_radius = -1; },
     "shader 0 \"sky\": the gradient's shape is out of range"},
    {"texture_bytes", [](Document& d) { std::get<Texture>(d.shaders[1].paint).rgba.pop_back(); },
     "shader 1 \"wood\": the texture's size and bytes disagree"},
};

INSTANTIATE_TEST_SUITE_P(, FaultyDocument, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(Validate, refuses_more_layers_than_the_limit) {
  Document document = some_document();
  document.layers.resize(limits::kLayers + 1);
  EXPECT_EQ(validate(Context{}, document).code, StatusCode::limit);
}

TEST(Validate, refuses_more_stops_in_one_list_than_the_limit) {
  Document document = some_document();
  second_curve(document).left.blur_radius.stops.assign(limits::kStopsPerList + 1, {0, 1});
  EXPECT_EQ(validate(Context{}, document).code, StatusCode::limit);
  document = some_document();
  gradient_of(document).stops.assign(limits::kStopsPerList + 1, {});
  EXPECT_EQ(validate(Context{}, document).code, StatusCode::limit);
}

TEST(Validate, refuses_more_curves_than_the_limit_over_all_layers) {
  Document document = some_document();
  Curve curve;
  curve.control_points.resize(4);
  document.layers.push_back({"many", std::vector<Curve>(limits::kCurves - 3, curve)});
  EXPECT_TRUE(validate(Context{}, document).ok());
  document.layers[0].curves.push_back(curve);
  const Status status = validate(Context{}, document);
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.message, "200001 curves; the limit is 200000 curves");
  EXPECT_EQ(status.limit, "curves");
}

TEST(Validate, refuses_more_control_points_than_the_limit) {
  Document document = some_document();
  second_curve(document).control_points.resize(3 * (limits::kControlPoints / 3) + 4);
  EXPECT_EQ(validate(Context{}, document).code, StatusCode::limit);
}

TEST(Validate, refuses_more_shaders_on_a_layer_than_the_limit) {
  Document document = some_document();
  document.shaders.resize(limits::kShadersPerLayer + 2, document.shaders[0]);
  Curve curve = some_curve();
  for (std::uint32_t i = 0; i < document.shaders.size(); ++i) {
    curve.left.color = {ShaderKind::image_domain, {}, i};
    document.layers[0].curves.push_back(curve);
  }
  EXPECT_EQ(validate(Context{}, document).code, StatusCode::limit);
}

}  // namespace
}  // namespace sfumato
