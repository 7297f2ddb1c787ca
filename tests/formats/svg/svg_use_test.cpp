// <use>: instances of layers, groups and curves; symbols and nested <svg>.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

const std::string kFish =
    "<defs><g id='fish' sf:diffuse='true'><path id='back' d='M1 2 h9' sf:left='red'/></g></defs>";

std::vector<LayerInstance> instances_of(const Document& document) {
  std::vector<LayerInstance> instances;
  for (const StackItem& item : document.stack) {
    if (const auto* instance = std::get_if<LayerInstance>(&item)) instances.push_back(*instance);
  }
  return instances;
}

TEST(SvgUse, of_a_layer_is_another_instance_of_it) {
  const Document document =
      read(svg(kFish + "<use href='#fish'/><use href='#fish' x='10' y='20' opacity='.5' "
                       "transform='scale(2)'/>"))
          .document;
  ASSERT_EQ(document.layers.size(), 1u);
  const auto instances = instances_of(document);
  ASSERT_EQ(instances.size(), 2u);
  EXPECT_EQ(document.stack.size(), 2u);
  EXPECT_EQ(instances[0].artboard_from_layer, Affine{});
  EXPECT_EQ(instances[1].artboard_from_layer, (Affine{2, 0, 0, 2, 20, 40}));
  EXPECT_EQ(instances[1].opacity, .5f);
  EXPECT_EQ(instances[1].layer, 0u);
}

TEST(SvgUse, of_a_layer_that_is_drawn_itself_is_an_instance_too) {
  const Document document = read(svg("<g id='a' transform='translate(1 0)' sf:diffuse='true'>"
                                     "<path d='M1 2 h9'/></g><use href='#a' y='3'/>"))
                                .document;
  EXPECT_EQ(document.layers.size(), 1u);
  ASSERT_EQ(document.stack.size(), 2u);
  EXPECT_EQ(instances_of(document)[1].artboard_from_layer, (Affine{1, 0, 0, 1, 1, 3}));
}

TEST(SvgUse, before_what_it_refers_to_works) {
  EXPECT_EQ(read(svg("<use href='#fish'/>" + kFish)).document.stack.size(), 1u);
}

TEST(SvgUse, with_the_old_name_of_href_works) {
  const std::string text = svg(kFish + "<use xlink:href='#fish'/>");
  EXPECT_EQ(read(text).document.stack.size(), 1u);
  EXPECT_EQ(read(svg(kFish + "<use x:href='#fish' xlink:href='#no' href='#fish'/>",
                     "xmlns:x='http://www.w3.org/1999/xlink'"))
                .document.stack.size(),
            1u);
}

TEST(SvgUse, of_a_group_draws_each_of_its_layers) {
  const Document document =
      read(svg(kFish + "<defs><g id='school'><use href='#fish'/><use href='#fish' x='5'/></g>"
                       "</defs><use href='#school'/><use href='#school' y='7' opacity='.5'/>"))
          .document;
  EXPECT_EQ(document.layers.size(), 1u);
  ASSERT_EQ(document.stack.size(), 6u);
  EXPECT_TRUE(std::holds_alternative<GroupBegin>(document.stack[2]));
  EXPECT_TRUE(std::holds_alternative<GroupEnd>(document.stack[5]));
  EXPECT_EQ(instances_of(document)[3].artboard_from_layer, (Affine{1, 0, 0, 1, 5, 7}));
}

TEST(SvgUse, of_a_local_curve_is_another_stroke) {
  const Document document = read(svg("<path id='s' d='M1 2 h9' sf:left='red' sf:radius='2'/>"
                                     "<use id='t' href='#s' x='4'/>"))
                                .document;
  ASSERT_EQ(document.stack.size(), 2u);
  const auto& stroke = std::get<LocalStroke>(document.stack[1]);
  EXPECT_EQ(stroke.artboard_from_stroke, (Affine{1, 0, 0, 1, 4, 0}));
  EXPECT_EQ(stroke.curve.id, "t");
}

TEST(SvgUse, within_a_layer_copies_the_curve_with_its_transform) {
  const Document document =
      read(svg("<defs><path id='p' d='M1 2 h9' transform='scale(2)' sf:left='red'/></defs>"
               "<g sf:diffuse='true'><use id='q' href='#p' x='10' transform='scale(1 -1)'/>"
               "<use href='#p'/></g>"))
          .document;
  ASSERT_EQ(document.layers[0].curves.size(), 2u);
  const Curve& curve = document.layers[0].curves[0];
  EXPECT_EQ(curve.control_points[0], (Vec2{12, -4}));
  EXPECT_EQ(curve.id, "q");
  EXPECT_EQ(curve.right.color.kind, ShaderKind::curve_domain) << "mirrored";
  EXPECT_EQ(document.layers[0].curves[1].id, "");
}

TEST(SvgUse, within_a_layer_copies_groups_of_curves) {
  const Document document = read(svg("<defs><g id='p'><path d='M1 2 h9'/><path d='M1 4 h9'/></g>"
                                     "</defs><g sf:diffuse='true'><use href='#p'/></g>"))
                                .document;
  EXPECT_EQ(document.layers[0].curves.size(), 2u);
}

TEST(SvgUse, of_a_symbol_fits_its_view_box) {
  const Document document =
      read(svg("<symbol id='s' viewBox='0 0 10 10' overflow='visible'><g sf:diffuse='true'>"
               "<path d='M1 2 h9'/></g></symbol><use href='#s' x='5' width='40' height='20'/>"))
          .document;
  ASSERT_EQ(document.stack.size(), 1u) << "a symbol is not drawn by itself";
  EXPECT_EQ(instances_of(document)[0].artboard_from_layer, (Affine{2, 0, 0, 2, 15, 0}));
}

TEST(SvgUse, of_a_symbol_that_would_be_clipped_is_told) {
  const auto warnings =
      warnings_of(svg("<symbol id='s' viewBox='0 0 10 10'><g sf:diffuse='true'>"
                      "<path sf:left='red' d='M1 2 h9'/></g></symbol><use href='#s'/>"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "a.svg:2:1: <symbol> is not clipped to its viewport; use "
            "overflow=\"visible\"");
}

TEST(SvgNestedSvg, has_its_place_and_view_box) {
  const Document document =
      read(svg("<svg x='10' y='5' width='50%' height='40' viewBox='0 0 100 10' overflow='visible' "
               "preserveAspectRatio='xMinYMax meet'><g sf:diffuse='true'><path d='M1 2 h9'/></g>"
               "</svg>"))
          .document;
  EXPECT_EQ(instances_of(document)[0].artboard_from_layer, (Affine{.5, 0, 0, .5, 10, 40}));
}

TEST(SvgUse, thousand_instances_are_no_trouble) {
  std::string uses;
  for (int i = 0; i < 1000; ++i) uses += "<use href='#fish' x='" + std::to_string(i) + "'/>";
  const Document document = read(svg(kFish + uses)).document;
  EXPECT_EQ(document.stack.size(), 1000u);
  EXPECT_EQ(document.layers.size(), 1u);
}

}  // namespace
}  // namespace sfumato::test
