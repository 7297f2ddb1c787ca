// Units of lengths, and lengths that are CSS properties.
#include <gtest/gtest.h>

#include "formats/each_text.hpp"
#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

/// Returns the end of a line in a layer, x in user units.
double end_x(const std::string& line, const std::string& around = "",
             const std::string& root = "") {
  const ReadDocument document = read(svg(
      "<g " + around + "><g sf:diffuse='true'><line sf:left='red' " + line + "/></g></g>", root));
  if (document.document.layers.empty()) return -1;
  return document.document.layers[0].curves.at(0).control_points.back().x;
}

TEST(SvgUnits, units_of_fonts_follow_the_font_size) {
  EXPECT_DOUBLE_EQ(end_x("x2='2em'"), 32);
  EXPECT_DOUBLE_EQ(end_x("x2='2em'", "font-size='10'"), 20);
  EXPECT_DOUBLE_EQ(end_x("x2='2EM' font-size='10px'", "font-size='30'"), 20);
  EXPECT_DOUBLE_EQ(end_x("x2='2ex'", "style='font-size:10px'"), 10);
  EXPECT_DOUBLE_EQ(end_x("x2='2ch'", "style='font-size:10px'"), 10);
  EXPECT_DOUBLE_EQ(end_x("x2='2em' font-size='1.5em'", "font-size='10'"), 30);
  EXPECT_DOUBLE_EQ(end_x("x2='2em' font-size='150%'", "font-size='10'"), 30);
  EXPECT_DOUBLE_EQ(end_x("x2='2em' style='font-size:larger'", "font-size='10'"), 24);
  EXPECT_DOUBLE_EQ(end_x("x2='2em'", "font-size='x-large'"), 48);
  EXPECT_DOUBLE_EQ(end_x("x2='2em'", "font-size='10'", "style='font-size:7px'"), 20);
  EXPECT_DOUBLE_EQ(end_x("x2='2rem'", "font-size='10'", "style='font-size:7px'"), 14);
  EXPECT_DOUBLE_EQ(end_x("x2='2rem' font-size='2rem'", "", "font-size='2em'"), 64);
  EXPECT_DOUBLE_EQ(end_x("x2='2em' style='font-size:initial'", "font-size='10'"), 32);
  EXPECT_DOUBLE_EQ(end_x("x2='2em' style='font-size:var(--s)'", "style='--s:10px'"), 20);
}

TEST(SvgUnits, units_of_the_viewport_follow_the_pictures_size) {
  EXPECT_DOUBLE_EQ(end_x("x2='50vw'"), 50);
  EXPECT_DOUBLE_EQ(end_x("x2='50vh'"), 25);
  EXPECT_DOUBLE_EQ(end_x("x2='50vmin'"), 25);
  EXPECT_DOUBLE_EQ(end_x("x2='50vmax'"), 50);
  EXPECT_DOUBLE_EQ(end_x("x2='5vw'", "", "width='400' height='200'"), 20);
}

TEST(SvgUnits, other_units_are_those_of_css) {
  EXPECT_DOUBLE_EQ(end_x("x2='4q'"), 96 / 25.4);
  EXPECT_DOUBLE_EQ(end_x("x2='1mm'"), 96 / 25.4);
  EXPECT_DOUBLE_EQ(end_x("x2='1IN'"), 96);
  EXPECT_EQ(status_of(svg_layer("<circle r='1furlong'/>")).message,
            "r of <circle>: \"1furlong\" has an unknown unit; use px, em, % or another unit "
            "of CSS");
}

/// Returns the box of the only curve.
Box box_of(const std::string& shape, const std::string& rules = "") {
  const ReadDocument document =
      read(svg("<style>" + rules + "</style><g sf:diffuse='true'>" + shape + "</g>"));
  EXPECT_TRUE(document.warnings.empty())
      << (document.warnings.empty() ? "" : to_string(document.warnings[0]));
  Box box;
  for (const Layer& layer : document.document.layers) {
    for (const Curve& curve : layer.curves) {
      for (const Vec2 point : curve.control_points) box.extend(point);
    }
  }
  return box;
}

TEST(SvgUnits, geometry_may_be_declared_in_css) {
  const Box expected{{10, 20}, {40, 30}};
  EXPECT_EQ(box_of("<rect sf:left='red' x='10' y='20' width='30' height='10'/>"), expected);
  EXPECT_EQ(box_of("<rect sf:left='red' style='x:10px;y:20px;width:30%;height:20%'/>"), expected);
  EXPECT_EQ(box_of("<rect sf:left='red' x='1' width='9' height='9'/>",
                   "rect{x:10px;y:20px;width:30px;height:10px}"),
            expected);
  EXPECT_EQ(box_of("<ellipse sf:left='red' style='cx:25px;cy:25px;rx:15px;ry:5px'/>"), expected);
  EXPECT_EQ(box_of("<circle sf:left='red' r='1'/>", "circle{r:5px;cx:5px;cy:5px}"),
            (Box{{0, 0}, {10, 10}}));
  EXPECT_EQ(box_of("<path sf:left='red' d='M0 0h1' style='d:path(\"M10 20L40 30\")'/>"), expected);
  EXPECT_EQ(warnings_of(svg_layer("<rect sf:left='red' width='auto' height='9'/>"))[0],
            "a.svg:3:1: <rect> has a part of no length, or draws nothing; that is left out");
}

TEST(SvgUnits, declarations_need_units) {
  const auto warnings =
      warnings_of(svg_layer("<rect sf:left='red' width='9' height='9' style='width:20'/>"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "a.svg:3:1: \"width: 20\" is left out: its value is not understood");
}

}  // namespace
}  // namespace sfumato::test
