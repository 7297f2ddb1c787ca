// Transforms: what is baked into curves, what goes to the layer's place, units of radii.
#include <gtest/gtest.h>

#include "formats/svg_support.hpp"

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

TEST(SvgTransform, transform_in_style_and_transform_origin_are_told) {
  const auto warnings = warnings_of(svg_layer(
      "<path sf:left='red' style='transform:scale(2)' transform-origin='3 3' d='M1 2 L3 4'/>"));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0],
            "a.svg:3:1: a transform in style is not read; expected the attribute transform");
  EXPECT_EQ(warnings[1], "a.svg:3:1: transform-origin of <path> is not read");
}

}  // namespace
}  // namespace sfumato::test
