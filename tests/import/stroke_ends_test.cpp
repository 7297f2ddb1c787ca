// Ends of strokes: caps at the ends of open paths, and strokes too thin to draw in their own width.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "base/text/number_text.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

Document drawn_strokes(const std::string& shape) {
  Context context;
  const std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><g fill='none' "
      "stroke='#000'>" +
      shape + "</g></svg>";
  Result<ImportedSvg> made = import_svg(context, text, "a.svg");
  EXPECT_TRUE(made) << (made ? "" : to_string(made.status())) << "\n" << text;
  return made ? std::move(made->document) : Document{};
}

Box extent_of_curves(const Document& document) {
  Box box;
  for (const Layer& layer : document.layers) {
    for (const Curve& curve : layer.curves) {
      for (const Vec2 p : curve.control_points) box.extend(p);
    }
  }
  return box;
}

float opacity_of_first_layer(const Document& document) {
  for (const StackItem& item : document.stack) {
    if (const auto* instance = std::get_if<LayerInstance>(&item)) return instance->opacity;
  }
  return 0;
}

constexpr double kMiterLeft = 11.9098;  // of the triangle below: 20 − 5 / tan(half the angle)
constexpr double kButtLeft = 15.5279;   // 20 − 5 sin of the angle

TEST(StrokeEnds, a_path_that_returns_to_its_start_has_caps_unless_it_is_closed) {
  const std::string path = "stroke-width='10' d='M20 80L50 20L80 80L20 80";
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<path " + path + "z'/>")).min.x, kMiterLeft, 1e-3);
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<path " + path + "'/>")).min.x, kButtLeft, 1e-3);
  const std::string square = "<path stroke-linecap='square' " + path + "'/>";
  EXPECT_NEAR(extent_of_curves(drawn_strokes(square)).max.y, 86.7082, 1e-3);
}

TEST(StrokeEnds, a_dash_around_such_a_path_has_caps_too) {
  const std::string path = "stroke-dasharray='999' stroke-width='10' d='M20 80L50 20L80 80L20 80";
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<path " + path + "z'/>")).min.x, kMiterLeft, 1e-3);
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<path " + path + "'/>")).min.x, kButtLeft, 1e-3);
}

TEST(StrokeEnds, a_polyline_that_returns_is_open_and_a_polygon_is_closed) {
  const std::string points = " stroke-width='10' points='20 80 50 20 80 80 20 80'/>";
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<polyline" + points)).min.x, kButtLeft, 1e-3);
  EXPECT_NEAR(extent_of_curves(drawn_strokes("<polygon" + points)).min.x, kMiterLeft, 1e-3);
}

TEST(StrokeEnds, a_stroke_thinner_than_curves_may_be_apart_is_wider_and_less_opaque) {
  constexpr double kWeld = 100.0 / 16384;
  for (const double welds : {0.25, 1.0, 3.9}) {
    const double width = welds * kWeld;
    const Document document =
        drawn_strokes("<path d='M20 50H80' stroke-width='" + number_text(width) + "'/>");
    const Box box = extent_of_curves(document);
    ASSERT_FALSE(box.empty()) << welds;
    const float opacity = opacity_of_first_layer(document);
    EXPECT_NEAR(opacity * box.height(), width, 1e-3 * width) << welds;
    EXPECT_LT(box.height(), 8 * kWeld) << welds;
  }
}

TEST(StrokeEnds, a_thin_stroke_of_a_gradient_and_of_a_scaled_shape_is_drawn) {
  const Document document = drawn_strokes(
      "<linearGradient id='g'><stop stop-color='red'/><stop offset='1'/></linearGradient>"
      "<path transform='scale(.01)' d='M2000 5000L8000 5500' stroke='url(#g)'/>");
  EXPECT_FALSE(extent_of_curves(document).empty());
  EXPECT_NEAR(opacity_of_first_layer(document), 0.01 / (6 * 100.0 / 16384), 1e-4);
}

/// As browsers draw it; the handles would turn the caps by 45 degrees.
TEST(StrokeEnds, handles_that_are_far_shorter_than_the_stroke_is_wide_turn_no_cap) {
  const std::string stroke = "<path stroke-width='10' d='M20 80";
  const Box line = extent_of_curves(drawn_strokes(stroke + "L80 20'/>"));
  const Box curve = extent_of_curves(drawn_strokes(stroke + "C20.05 80 80 20 80.05 20'/>"));
  EXPECT_NEAR(curve.min.x, line.min.x, 0.1);
  EXPECT_NEAR(curve.max.y, line.max.y, 0.1);
}

TEST(StrokeEnds, a_stroke_that_nobody_sees_is_not_drawn) {
  EXPECT_TRUE(
      extent_of_curves(drawn_strokes("<path d='M20 50H80' stroke-width='.0005'/>")).empty());
}

TEST(StrokeEnds, strokes_that_are_thick_enough_keep_their_opacity) {
  EXPECT_EQ(opacity_of_first_layer(drawn_strokes("<path d='M20 50H80' stroke-width='.03'/>")), 1);
}

/// All sides of the stroke pass the middle of the circle.
TEST(StrokeEnds, a_stroke_wider_than_its_circle_is_a_disk) {
  const Document document = drawn_strokes(
      "<path stroke-width='5' d='M51.3 50A1.3 1.3 0 1 0 48.7 50A1.3 1.3 0 1 0 51.3 49.9999L50 "
      "50z'/>");
  ASSERT_EQ(document.layers.size(), 1u);
  const Box box = extent_of_curves(document);
  EXPECT_NEAR(box.min.x, 50 - 3.8, 0.05);
  EXPECT_NEAR(box.max.y, 50 + 3.8, 0.05);
}

}  // namespace
}  // namespace sfumato
