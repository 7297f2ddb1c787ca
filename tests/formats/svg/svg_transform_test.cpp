// Transforms: those baked into curves, those of a layer's placement, and the units of radii.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

Vec2 image_of_point(const std::string& transform, Vec2 p = {1, 2}) {
  const Curve curve = curve_of("<path transform='" + transform + "' d='M" + std::to_string(p.x) +
                               " " + std::to_string(p.y) + " L30 40'/>");
  return curve.control_points.empty() ? Vec2{} : curve.control_points[0];
}

LayerInstance instance_of(const std::string& content) {
  const ReadDocument document = read(svg(content));
  for (const StackItem& item : document.document.stack) {
    if (const auto* instance = std::get_if<LayerInstance>(&item)) return *instance;
  }
  ADD_FAILURE() << "no instance";
  return {};
}

TEST(SvgTransform, every_function_is_known) {
  expect_points({image_of_point("translate(10)")}, {{11, 2}});
  expect_points({image_of_point("translate(10,20)")}, {{11, 22}});
  expect_points({image_of_point("scale(3)")}, {{3, 6}});
  expect_points({image_of_point("scale(3 -1)")}, {{3, -2}});
  expect_points({image_of_point("matrix(1 2 3 4 5 6)")}, {{12, 16}});
  expect_points({image_of_point("rotate(30)", {2, 0})}, {{1.7320508075688772, 1}});
  expect_points({image_of_point("skewX(45)")}, {{3, 2}});
  expect_points({image_of_point("skewY(45)")}, {{1, 3}});
}

TEST(SvgTransform, quarter_turns_are_exact) {
  expect_points({image_of_point("rotate(90)")}, {{-2, 1}}, 0);
  expect_points({image_of_point("rotate(-180)")}, {{-1, -2}}, 0);
  expect_points({image_of_point("rotate(630)")}, {{2, -1}}, 0);
  expect_points({image_of_point("rotate(90 1 1)")}, {{0, 1}}, 0);
}

TEST(SvgTransform, functions_apply_from_right_to_left) {
  expect_points({image_of_point(" translate(10 0) , scale(2)\n")}, {{12, 4}});
}

TEST(SvgTransform, groups_in_a_layer_are_baked_into_its_curves) {
  const Curve curve = curve_of(
      "<g transform='translate(10 0)'><g transform='scale(2)'><path d='M1 2 L3 4'/></g></g>");
  expect_points({curve.control_points.front(), curve.control_points.back()}, {{12, 4}, {16, 8}});
}

TEST(SvgTransform, transforms_of_the_layer_and_around_it_are_its_place) {
  const LayerInstance instance = instance_of(
      "<g transform='translate(10 0)'><g sf:diffuse='true' transform='scale(2)'>"
      "<path d='M1 2 L3 4'/></g></g>");
  EXPECT_EQ(instance.artboard_from_layer, (Affine{2, 0, 0, 2, 10, 0}));
}

TEST(SvgTransform, curve_in_a_layer_stays_in_the_layers_frame) {
  const ReadDocument document =
      read(svg("<g sf:diffuse='true' transform='scale(2)'><path d='M1 2 L3 4'/></g>"));
  EXPECT_EQ(document.document.layers[0].curves[0].control_points[0], (Vec2{1, 2}));
}

TEST(SvgTransform, radii_grow_by_the_root_of_the_area) {
  const Curve curve =
      curve_of("<path transform='scale(2 8)' d='M0 0 H9' sf:blur='1, 3' sf:right-blur='5'/>");
  ASSERT_EQ(curve.left.blur_radius.stops.size(), 2u);
  EXPECT_FLOAT_EQ(curve.left.blur_radius.stops[0].value, 4);
  EXPECT_FLOAT_EQ(curve.left.blur_radius.stops[1].value, 12);
  EXPECT_FLOAT_EQ(curve.right.blur_radius.stops[0].value, 20);
}

TEST(SvgTransform, mirrored_curve_shows_its_colours_mirrored) {
  const std::string attributes =
      " d='M0 0 H9' sf:left='red' sf:right='lime' sf:left-blur='2' sf:right-opacity='.5'/>";
  const Curve plain = curve_of("<path" + attributes);
  const Curve mirrored = curve_of("<path transform='scale(1 -1)'" + attributes);
  EXPECT_EQ(plain.left.color.stops.stops[0].value, (Rgb{1, 0, 0}));
  EXPECT_EQ(mirrored.left, plain.right);
  EXPECT_EQ(mirrored.right, plain.left);
  const Curve turned = curve_of("<path transform='rotate(180)'" + attributes);
  EXPECT_EQ(turned.left, plain.left);
  const Curve twice =
      curve_of("<g transform='scale(-1 1)'><path transform='scale(1 -1)'" + attributes + "</g>");
  EXPECT_EQ(twice.left, plain.left);
}

TEST(SvgTransform, local_curve_keeps_its_frame_and_gets_a_place) {
  const ReadDocument document =
      read(svg("<g transform='translate(10 0)'><path transform='scale(-2 2)' d='M1 2 L3 4' "
               "sf:left='red' sf:radius='3'/></g>"));
  ASSERT_EQ(document.document.stack.size(), 1u);
  const auto& stroke = std::get<LocalStroke>(document.document.stack[0]);
  EXPECT_EQ(stroke.artboard_from_stroke, (Affine{-2, 0, 0, 2, 10, 0}));
  EXPECT_EQ(stroke.curve.control_points[0], (Vec2{1, 2}));
  EXPECT_EQ(stroke.curve.influence_radius.stops[0].value, 3);
}

TEST(SvgTransform, what_is_flattened_to_nothing_is_left_out_with_a_warning) {
  const std::string flat = svg_layer("<path transform='scale(0 1)' d='M1 2 L3 4'/>");
  EXPECT_EQ(warnings_of(flat)[0],
            "a.svg:3:1: <path> is flattened to nothing by its transform; it is left out");
  EXPECT_TRUE(read(svg("<g transform='scale(0)' sf:diffuse='true'/>")).document.stack.empty());
}

/// Returns the image of (1, 2), with these attributes of the path.
Vec2 image_by(const std::string& attributes, const std::string& rules = "") {
  const ReadDocument document = read(svg("<style>" + rules +
                                         "</style><g sf:diffuse='true'><path "
                                         "sf:left='red' d='M1 2 L11 22' " +
                                         attributes + "/></g>"));
  EXPECT_TRUE(document.warnings.empty())
      << (document.warnings.empty() ? "" : to_string(document.warnings[0]));
  return document.document.layers.at(0).curves.at(0).control_points.at(0);
}

TEST(SvgTransform, functions_of_css_have_units) {
  const auto by_style = [](const std::string& value) {
    return image_by("style='transform:" + value + "'");
  };
  expect_points({by_style("translate(10px)")}, {{11, 2}});
  expect_points({by_style("translate(10px, 1em)")}, {{11, 18}});
  expect_points({by_style("translate(10%,10%)")}, {{11, 7}});
  expect_points({by_style("translateX(1in) translateY(2px)")}, {{97, 4}});
  expect_points({by_style("translate3d(10px,20px,30px)")}, {{11, 22}});
  expect_points({by_style("scale(3)")}, {{3, 6}});
  expect_points({by_style("scale(3,-100%)")}, {{3, -2}});
  expect_points({by_style("scaleX(3)")}, {{3, 2}});
  expect_points({by_style("SCALEY(3)")}, {{1, 6}});
  expect_points({by_style("scaleZ(3)")}, {{1, 2}});
  expect_points({by_style("matrix(1,2,3,4,5,6)")}, {{12, 16}});
  for (const char* turn : {"90deg", "100grad", ".25turn", "-270deg"}) {
    expect_points({by_style("rotate(" + std::string(turn) + ")")}, {{-2, 1}}, 0);
  }
  expect_points({by_style("rotate(1.5707963267948966rad)")}, {{-2, 1}});
  expect_points({by_style("rotateZ(0)")}, {{1, 2}}, 0);
  expect_points({by_style("skew(45deg)")}, {{3, 2}});
  expect_points({by_style("skew(0, 45deg)")}, {{1, 3}});
  expect_points({by_style("skewX(45deg) skewY(0)")}, {{3, 2}});
  expect_points({by_style("none")}, {{1, 2}}, 0);
  expect_points({image_by("", "path{transform:scale(3)}")}, {{3, 6}});
  expect_points({image_by("transform='scale(2)'", "path{transform:scale(3)}")}, {{3, 6}});
  expect_points({image_by("transform='scale(2)'", "path{transform:none}")}, {{1, 2}});
  expect_points({image_by("transform='none'")}, {{1, 2}});
}

TEST(SvgTransform, invalid_functions_of_css_are_dropped) {
  for (const std::string value :
       {"translate(10)", "translate(10px 10px)", "rotate(45)", "scale()", "scale(1,2,3)",
        "matrix(1,2,3,4,5)", "rotateX(3deg)", "scale(2) junk", "perspective(3px)"}) {
    const ReadDocument document = read(svg_layer(
        "<path sf:left='red' d='M1 2h9' transform='scale(2)' style='transform:" + value + "'/>"));
    EXPECT_EQ(document.warnings.size(), 1u) << value;
    EXPECT_EQ(document.document.layers.at(0).curves.at(0).control_points.at(0), (Vec2{2, 4}))
        << value;
  }
}

TEST(SvgTransform, transforms_turn_about_their_origin) {
  const std::string turn = "style='transform:rotate(90deg);transform-origin:";
  expect_points({image_by(turn + "3px 3px'")}, {{4, 1}});
  expect_points({image_by("transform='rotate(90)' transform-origin='3 3'")}, {{4, 1}});
  // Percentages of the viewport, 100 × 50.
  expect_points({image_by(turn + "50% 50%'")}, {{73, -24}});
  expect_points({image_by(turn + "center'")}, {{73, -24}});
  expect_points({image_by(turn + "top right'")}, {{98, -99}});
  expect_points({image_by(turn + "bottom'")}, {{98, 1}});
  expect_points({image_by(turn + "left 5px 1px'")}, {{3, 6}});
  expect_points({image_by("transform-origin='3 3'")}, {{1, 2}}, 0);
}

TEST(SvgTransform, the_origin_may_be_in_the_bounding_box) {
  const std::string half = "style='transform:scale(.5);transform-box:fill-box;transform-origin:";
  expect_points({image_by(half + "0 0'")}, {{1, 2}});
  expect_points({image_by("style='transform:scale(.5);transform-box:fill-box'")}, {{1, 2}});
  expect_points({image_by(half + "center'")}, {{3.5, 7}});
  expect_points({image_by("style='transform:translate(10%,10%);transform-box:fill-box'")},
                {{2, 4}});
  // For a group: the box of its shapes, with their transforms.
  const ReadDocument document = read(svg_layer(
      "<g " + half +
      "100% 100%'><path sf:left='red' d='M1 2 L11 22'/><g transform='scale(2)'>"
      "<rect display='none' width='90' height='9'/><use href='#c'/><circle id='c' sf:left='red' "
      "cx='20' cy='10' r='5'/></g></g>"));
  // The box is (1, 0) to (50, 30).
  expect_points({document.document.layers.at(0).curves.at(0).control_points.at(0)}, {{25.5, 16}});
}

TEST(SvgTransform, paints_have_the_transforms_of_css) {
  const auto map_of = [](const std::string& attributes) {
    const ReadDocument document =
        read(svg("<linearGradient id='a' gradientUnits='userSpaceOnUse' " + attributes +
                 "><stop/></linearGradient><g sf:diffuse='true'><path d='M0 0h9v9' "
                 "sf:left='url(#a)'/></g>"));
    EXPECT_TRUE(document.warnings.empty()) << attributes;
    return std::get<GradientFill>(document.document.shaders.at(0).paint).layer_from_gradient;
  };
  EXPECT_EQ(map_of("transform-origin='1 1'"), Affine{}) << "nothing turns";
  EXPECT_EQ(map_of("gradientTransform='scale(2)' transform-origin='3 4'"),
            (Affine{2, 0, 0, 2, -3, -4}));
  EXPECT_EQ(map_of("style='transform:scale(2)'"), (Affine{2, 0, 0, 2, 0, 0}));
  EXPECT_EQ(map_of("style='transform:scale(2)' gradientTransform='scale(3)'"),
            (Affine{2, 0, 0, 2, 0, 0}));
}

TEST(SvgTransform, nested_boxes_take_time_in_proportion_to_depth) {
  std::string groups, ends;
  for (int i = 0; i < 200; ++i) {
    groups += "<g style='transform:scale(1);transform-box:fill-box'>";
    ends += "</g>";
  }
  const Status status = status_of(svg_layer(groups + "<path sf:left='red' d='M1 2h9'/>" + ends));
  EXPECT_TRUE(status.ok()) << to_string(status);
}

TEST(SvgTransform, a_circle_of_uses_has_no_box) {
  const Status status = status_of(
      svg("<g id='a' style='transform:scale(2);transform-box:fill-box'><use href='#a'/></g>"));
  EXPECT_FALSE(status.ok());
}

}  // namespace
}  // namespace sfumato::test
