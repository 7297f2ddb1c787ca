// Gradients as shaders: geometry, units, inheritance, sharing.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

const std::string kStops = "<stop stop-color='red'/><stop offset='1' stop-color='#00f'/>";

Document painted(const std::string& paint, const std::string& curves = "") {
  const std::string one = "<path d='M10 20 L30 60' sf:left='url(#p)'/>";
  return read(svg("<defs>" + paint + "</defs><g sf:diffuse='true'>" +
                  (curves.empty() ? one : curves) + "</g>"))
      .document;
}

GradientFill gradient_of(const std::string& paint, const std::string& curves = "") {
  const Document document = painted(paint, curves);
  if (document.shaders.size() != 1) {
    ADD_FAILURE() << document.shaders.size() << " shaders";
    return {};
  }
  return std::get<GradientFill>(document.shaders[0].paint);
}

std::string linear(const std::string& attributes, const std::string& stops = kStops) {
  return "<linearGradient id='p' " + attributes + ">" + stops + "</linearGradient>";
}

std::string radial(const std::string& attributes) {
  return "<radialGradient id='p' gradientUnits='userSpaceOnUse' " + attributes + ">" + kStops +
         "</radialGradient>";
}

std::vector<double> offsets_of_stops(const std::string& stops) {
  std::vector<double> offsets;
  for (const auto& stop : gradient_of(linear("", stops)).stops) offsets.push_back(stop.offset);
  return offsets;
}

TEST(SvgGradient, in_user_space_has_its_coordinates) {
  const GradientFill fill =
      gradient_of(linear("gradientUnits='userSpaceOnUse' x1='1' y1='10%' x2='50%' y2='4'"));
  const auto shape = std::get<LinearGradient>(fill.shape);
  EXPECT_EQ(shape.start, (Vec2{1, 5}));
  EXPECT_EQ(shape.end, (Vec2{50, 4}));
  EXPECT_EQ(fill.layer_from_gradient, Affine{});
}

TEST(SvgGradient, in_the_bounding_box_runs_from_left_to_right_unless_said) {
  const GradientFill fill = gradient_of(linear(""));
  const auto shape = std::get<LinearGradient>(fill.shape);
  EXPECT_EQ(shape.start, (Vec2{0, 0}));
  EXPECT_EQ(shape.end, (Vec2{1, 0}));
  EXPECT_EQ(fill.layer_from_gradient, (Affine{20, 0, 0, 40, 10, 20}));
}

TEST(SvgGradient, bounding_box_is_that_of_the_curve_itself) {
  const GradientFill fill =
      gradient_of(linear(""), "<path d='M0 0 C0 40 100 40 100 0' sf:right='url(#p)'/>");
  EXPECT_EQ(fill.layer_from_gradient, (Affine{100, 0, 0, 30, 0, 0}));
}

TEST(SvgGradient, transforms_of_gradient_and_shape_are_in_its_frame) {
  const GradientFill fill =
      gradient_of(linear("gradientUnits='userSpaceOnUse' gradientTransform='translate(1 2)'"),
                  "<g transform='translate(10 0)'><path transform='scale(2)' d='M0 0 h9' "
                  "sf:left='url(#p)'/></g>");
  EXPECT_EQ(fill.layer_from_gradient, (Affine{2, 0, 0, 2, 12, 4}));
}

TEST(SvgGradient, radial_has_centre_radius_and_focus) {
  const auto shape =
      std::get<RadialGradient>(gradient_of(radial("cx='10' cy='20' r='8' fx='12'")).shape);
  EXPECT_EQ(shape.center, (Vec2{10, 20}));
  EXPECT_EQ(shape.focus, (Vec2{12, 20}));
  EXPECT_EQ(shape.radius, 8);
  const auto plain = std::get<RadialGradient>(gradient_of(radial("")).shape);
  EXPECT_EQ(plain.center, (Vec2{50, 25}));
  EXPECT_EQ(plain.focus, plain.center);
}

TEST(SvgGradient, a_focal_circle_stays_where_it_is) {
  const auto shape =
      std::get<RadialGradient>(gradient_of(radial("cx='0' cy='0' r='10' fy='99' fr='25%'")).shape);
  EXPECT_EQ(shape.focus, (Vec2{0, 99}));
  EXPECT_GT(shape.focal_radius, 0);
}

TEST(SvgGradient, a_focus_on_the_circle_is_moved_into_it) {
  const auto shape =
      std::get<RadialGradient>(gradient_of(radial("cx='0' cy='0' r='10' fx='0' fy='10'")).shape);
  EXPECT_EQ(shape.focus.x, 0);
  EXPECT_LT(shape.focus.y, 10);
  EXPECT_GT(shape.focus.y, 9.98);
}

TEST(SvgGradient, of_no_length_has_the_colour_of_its_last_stop) {
  for (const std::string& paint : {linear("x1='1' x2='1'"), radial("r='0'")}) {
    const GradientFill fill = gradient_of(paint);
    ASSERT_EQ(fill.stops.size(), 1u);
    EXPECT_EQ(fill.stops[0].color, (Rgb{0, 0, 1}));
  }
}

TEST(SvgGradient, spread_methods) {
  EXPECT_EQ(gradient_of(linear("")).spread, SpreadMethod::pad);
  EXPECT_EQ(gradient_of(linear("spreadMethod='reflect'")).spread, SpreadMethod::reflect);
  EXPECT_EQ(gradient_of(linear("spreadMethod='repeat'")).spread, SpreadMethod::repeat);
}

TEST(SvgGradient, offsets_are_clamped_and_never_fall) {
  EXPECT_EQ(offsets_of_stops("<stop offset='-1'/><stop offset='50%'/><stop offset='.3'/>"
                             "<stop offset='7'/>"),
            (std::vector<double>{0, .5, .5, 1}));
}

TEST(SvgGradient, stops_have_colour_and_opacity_in_attributes_styles_and_sheets) {
  const GradientFill fill =
      gradient_of("<style>.s{stop-color:lime;stop-opacity:.5}</style>" +
                  linear("",
                         "<stop stop-color='#ff000080' stop-opacity='50%'/><stop class='s'/>"
                         "<stop style='stop-color:rgb(0,0,255);stop-opacity:.25'/><stop/>"));
  ASSERT_EQ(fill.stops.size(), 4u);
  EXPECT_EQ(fill.stops[0].color, (Rgb{1, 0, 0}));
  EXPECT_NEAR(fill.stops[0].alpha, 0.251, 1e-3);
  EXPECT_EQ(fill.stops[1].color, (Rgb{0, 1, 0}));
  EXPECT_EQ(fill.stops[1].alpha, 0.5f);
  EXPECT_EQ(fill.stops[2].color, (Rgb{0, 0, 1}));
  EXPECT_EQ(fill.stops[2].alpha, 0.25f);
  EXPECT_EQ(fill.stops[3].color, (Rgb{0, 0, 0}));
}

TEST(SvgGradient, inherits_what_it_does_not_say) {
  const GradientFill fill = gradient_of(
      "<linearGradient id='a' x1='3' spreadMethod='repeat'>" + kStops +
      "</linearGradient><radialGradient id='b' href='#a' gradientUnits='userSpaceOnUse'/>" +
      linear("href='#b' x2='9' spreadMethod='reflect'", ""));
  EXPECT_EQ(fill.stops.size(), 2u);
  EXPECT_EQ(fill.spread, SpreadMethod::reflect);
  const auto shape = std::get<LinearGradient>(fill.shape);
  EXPECT_EQ(shape.start, (Vec2{3, 0})) << "from a linear gradient behind a radial one";
  EXPECT_EQ(shape.end, (Vec2{9, 0}));
}

TEST(SvgPaints, the_same_paint_at_the_same_place_is_one_shader) {
  const std::string paint = linear("gradientUnits='userSpaceOnUse'");
  const std::string curves =
      "<path d='M0 0 h9' sf:left='url(#p)' sf:right='url( \"#p\" )'/>"
      "<path d='M0 5 h9' sf:left='url(#p)' sf:right-opacity='url(#p)'/>";
  const Document document = painted(paint, curves);
  EXPECT_EQ(document.shaders.size(), 1u);
  EXPECT_EQ(document.shaders[0].id, "p");
  EXPECT_EQ(document.layers[0].curves[1].right.opacity.kind, ShaderKind::image_domain);
}

TEST(SvgPaints, the_same_paint_at_another_place_is_another_shader) {
  const std::string curves =
      "<path d='M0 0 h9' sf:left='url(#p)'/>"
      "<path transform='scale(2)' d='M0 5 h9' sf:left='url(#p)'/>";
  EXPECT_EQ(painted(linear("gradientUnits='userSpaceOnUse'"), curves).shaders.size(), 2u);
}

TEST(SvgPaints, the_boxes_of_curves_between_two_gradients_have_each_their_own_stops) {
  const std::string solid = "<linearGradient id='q' x1='0' x2='0' href='#r'/>";
  const std::string other =
      "<linearGradient id='r'><stop stop-color='#fff'/><stop offset='.5'/></linearGradient>";
  const auto curve = [](int end, const char* id) {
    return "<path d='M0 0L" + std::to_string(end) + " 9' sf:left='url(#" + id + ")'/>";
  };
  const Document document =
      painted(linear("") + solid + other, curve(10, "p") + curve(20, "p") + curve(30, "q") +
                                              curve(40, "r") + curve(50, "p") + curve(60, "r"));
  std::vector<double> last_offsets;
  for (const Shader& shader : document.shaders) {
    last_offsets.push_back(std::get<GradientFill>(shader.paint).stops.back().offset);
  }
  EXPECT_EQ(last_offsets, (std::vector<double>{1, 1, 0.5, 0.5, 1, 0.5}));
  EXPECT_EQ(std::get<GradientFill>(document.shaders[2].paint).stops.size(), 1u);
  EXPECT_EQ(std::get<GradientFill>(document.shaders[3].paint).stops.size(), 2u);
}

TEST(SvgPaints, huge_gradient_is_read_once_for_many_curves) {
  std::string stops, curves;
  for (int i = 0; i < 10'000; ++i) stops += "<stop/>";
  for (int i = 0; i < 10'000; ++i) curves += "<path d='M0 0 h9' sf:left='url(#p)'/>";
  EXPECT_EQ(painted(linear("gradientUnits='userSpaceOnUse'", stops), curves).shaders.size(), 1u);
}

}  // namespace
}  // namespace sfumato::test
