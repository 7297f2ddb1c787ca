// Small files of Orzan's XML: the content that is read, and the content that is ignored.
#include "sfumato/formats/orzan/orzan.hpp"

#include <gtest/gtest.h>

#include <string>

#include "sfumato/base/limits.hpp"

namespace sfumato {
namespace {

const std::string kPoints =
    "<control_points_set><control_point x='1' y='2'/><control_point x='3' y='4'/>"
    "<control_point x='5' y='6'/><control_point x='7' y='8'/></control_points_set>";

std::string curve_set(const std::string& content) {
  return "<!DOCTYPE CurveSetXML>\n<curve_set image_width='30' image_height='20' nb_curves='9'>\n" +
         content + "\n</curve_set>\n";
}

std::string one_curve(const std::string& parts) {
  return curve_set("<curve>" + kPoints + parts + "</curve>");
}

ReadDocument read(const std::string& xml) {
  Context context;
  Result<ReadDocument> result = read_orzan(context, xml, "a.xml");
  EXPECT_TRUE(result.ok()) << to_string(result.status());
  return result ? std::move(*result) : ReadDocument{};
}

Curve only_curve(const std::string& xml) {
  ReadDocument document = read(xml);
  if (document.document.layers.empty() || document.document.layers[0].curves.size() != 1) {
    ADD_FAILURE() << "not one curve";
    return {};
  }
  return document.document.layers[0].curves[0];
}

TEST(Orzan, axes_are_exchanged) {
  const Curve curve = only_curve(one_curve(""));
  const std::vector<Vec2> expected{{2, 1}, {4, 3}, {6, 5}, {8, 7}};
  EXPECT_EQ(curve.control_points, expected);
}

TEST(Orzan, width_of_the_canvas_is_its_width) {
  EXPECT_EQ(read(one_curve("")).document.artboard, (Box{{0, 0}, {30, 20}}));
}

TEST(Orzan, red_and_blue_are_exchanged) {
  const Curve curve = only_curve(one_curve(
      "<left_colors_set><left_color B='255' G='51' R='0' globalID='0'/></left_colors_set>"));
  ASSERT_EQ(curve.left.color.stops.stops.size(), 1u);
  EXPECT_EQ(curve.left.color.stops.stops[0].value, (Rgb{1, 0.2f, 0}));
}

TEST(Orzan, side_without_stops_is_open) {
  const Curve curve = only_curve(one_curve("<left_colors_set/>"));
  EXPECT_EQ(curve.left.color.kind, ShaderKind::open);
  EXPECT_EQ(curve.right.color.kind, ShaderKind::open);
  EXPECT_EQ(curve.left.opacity.kind, ShaderKind::open);
}

TEST(Orzan, neumann_side_is_a_barrier) {
  const Curve curve = only_curve(
      one_curve("<left_colors_set boundary='Neumann'><left_color R='1' G='1' B='1' globalID='0'/>"
                "</left_colors_set>"));
  EXPECT_EQ(curve.left.color.kind, ShaderKind::barrier);
  EXPECT_TRUE(curve.left.color.stops.empty());
}

TEST(Orzan, stops_are_sorted_stably_and_clamped_to_the_curve) {
  const auto color = [](const char* id, const char* red) {
    return std::string("<right_color R='0' G='0' B='") + red + "' globalID='" + id + "'/>";
  };
  const Curve curve = only_curve(
      one_curve("<right_colors_set>" + color("25", "255") + color("5", "51") + color("12", "204") +
                color("5", "102") + color("-3", "0") + "</right_colors_set>"));
  const ColorStops expected{StopSpace::parameter,
                            {{0, {0, 0, 0}},
                             {0.5, {0.2f, 0, 0}},
                             {0.5, {0.4f, 0, 0}},
                             {1, {0.8f, 0, 0}},
                             {1, {1, 0, 0}}}};
  EXPECT_EQ(curve.right.color.stops, expected);
}

/// Some programs number stops from 0 to 10000, whatever the number of pieces.
TEST(Orzan, stops_that_are_numbered_far_past_the_curve_are_scaled_with_a_warning) {
  const auto color = [](const char* id, const char* red) {
    return std::string("<right_color R='0' G='0' B='") + red + "' globalID='" + id + "'/>";
  };
  const ReadDocument document =
      read(one_curve("<right_colors_set>" + color("0", "0") + color("5000", "51") +
                     color("10000", "255") + "</right_colors_set>" +
                     "<blur_points_set><best_scale value='0' globalID='0'/>"
                     "<best_scale value='2' globalID='2500'/></blur_points_set>"));
  const Curve& curve = document.document.layers[0].curves[0];
  const ColorStops expected{StopSpace::parameter,
                            {{0, {0, 0, 0}}, {0.5, {0.2f, 0, 0}}, {1, {1, 0, 0}}}};
  EXPECT_EQ(curve.right.color.stops, expected);
  EXPECT_EQ(curve.left.blur_radius.stops.back().offset, 0.25);
  ASSERT_EQ(document.warnings.size(), 1u);
  EXPECT_TRUE(document.warnings[0].message.starts_with("stops are numbered past the end"));
}

TEST(Orzan, portals_are_told) {
  const ReadDocument document = read(curve_set(
      "<curve connects='1'>" + kPoints + "</curve><curve connects='0'>" + kPoints + "</curve>"));
  EXPECT_EQ(document.document.layers[0].curves.size(), 2u);
  ASSERT_EQ(document.warnings.size(), 1u);
  EXPECT_EQ(to_string(document.warnings[0]),
            "a.xml:3:1: portals (connects) are not read; the curve is an ordinary one");
}

TEST(Orzan, a_bad_curve_of_many_is_left_out_and_named) {
  const std::string good = "<curve>" + kPoints + "</curve>", few = "<curve/>";
  const std::string no_number = "<curve>" + kPoints +
                                "<left_colors_set><left_color R='-1.#IND' G='1' B='1' "
                                "globalID='0'/></left_colors_set></curve>";
  const ReadDocument document = read(curve_set(good + "\n" + few + good + no_number));
  EXPECT_EQ(document.document.layers[0].curves.size(), 2u);
  ASSERT_EQ(document.warnings.size(), 2u);
  EXPECT_EQ(to_string(document.warnings[0]),
            "a.xml:4:1: curve 2 is left out: the curve has 0 control points; use 3n+1 of them "
            "(4, 7, 10, …)");
  EXPECT_TRUE(document.warnings[1].message.starts_with("curve 4 is left out: R of <left_color>"))
      << document.warnings[1].message;
}

TEST(Orzan, colours_beyond_the_range_are_clamped_with_one_warning) {
  const ReadDocument document =
      read(one_curve("<left_colors_set><left_color B='300' G='-1' R='255' globalID='0'/>"
                     "</left_colors_set>"));
  const Curve& curve = document.document.layers[0].curves[0];
  EXPECT_EQ(curve.left.color.stops.stops[0].value, (Rgb{1, 0, 1}));
  EXPECT_EQ(document.warnings.size(), 1u);
}

TEST(Orzan, blur_of_zero_everywhere_is_no_blur) {
  const Curve curve = only_curve(one_curve(
      "<blur_points_set><best_scale value='0' globalID='0'/><best_scale value='0' globalID='10'/>"
      "</blur_points_set>"));
  EXPECT_TRUE(curve.left.blur_radius.empty());
  EXPECT_TRUE(curve.right.blur_radius.empty());
}

// R = 3 sqrt(2 pi) / 4 sigma.
TEST(Orzan, best_scale_becomes_a_radius_on_both_sides) {
  const Curve curve = only_curve(one_curve(
      "<blur_points_set><best_scale value='0' globalID='0'/><best_scale value='2' globalID='10'/>"
      "</blur_points_set>"));
  ASSERT_EQ(curve.left.blur_radius.stops.size(), 2u);
  EXPECT_EQ(curve.left.blur_radius.stops[0].value, 0);
  EXPECT_NEAR(curve.left.blur_radius.stops[1].value, 3.759942, 1e-5);
  EXPECT_EQ(curve.right.blur_radius, curve.left.blur_radius);
}

TEST(Orzan, constant_weight_is_the_curves_weight) {
  const Curve curve = only_curve(one_curve(
      "<weight_set><weight w='2.5' globalID='0'/><weight w='2.5' globalID='10'/></weight_set>"));
  EXPECT_EQ(curve.weight, 2.5);
}

TEST(Orzan, weight_that_varies_is_ignored_with_a_warning) {
  const ReadDocument document = read(one_curve(
      "<weight_set><weight w='2' globalID='0'/><weight w='3' globalID='10'/></weight_set>"));
  EXPECT_EQ(document.document.layers[0].curves[0].weight, 1);
  ASSERT_EQ(document.warnings.size(), 1u);
  EXPECT_EQ(document.warnings[0].where.line, 3);
}

TEST(Orzan, counters_are_ignored) {
  const ReadDocument document =
      read(curve_set("<curve nb_control_points='99' nb_left_colors='7'>" + kPoints + "</curve>"));
  EXPECT_EQ(document.document.layers[0].curves.size(), 1u);
  EXPECT_TRUE(document.warnings.empty());
}

TEST(Orzan, curve_of_length_zero_is_read) {
  const std::string point = "<control_point x='5' y='5'/>";
  const Curve curve = only_curve(curve_set("<curve><control_points_set>" + point + point + point +
                                           point + "</control_points_set></curve>"));
  EXPECT_EQ(curve.control_points, std::vector<Vec2>(4, Vec2{5, 5}));
}

TEST(Orzan, coordinates_outside_the_canvas_are_read) {
  const Curve curve = only_curve(curve_set(
      "<curve><control_points_set><control_point x='-255.5' y='9999999'/><control_point x='1e3' "
      "y='+2'/><control_point x=' .5 ' y='5.'/><control_point x='0' y='0'/></control_points_set>"
      "</curve>"));
  EXPECT_EQ(curve.control_points[0], (Vec2{9999999, -255.5}));
  EXPECT_EQ(curve.control_points[1], (Vec2{2, 1000}));
  EXPECT_EQ(curve.control_points[2], (Vec2{5, 0.5}));
}

TEST(Orzan, unknown_elements_bring_one_warning_for_each_kind) {
  const ReadDocument document = read(
      curve_set("<extra/>\n <extra/><curve>" + kPoints + "<more><deep/></more></curve>\n<extra/>"));
  EXPECT_EQ(document.document.layers[0].curves.size(), 1u);
  ASSERT_EQ(document.warnings.size(), 2u);
  EXPECT_EQ(to_string(document.warnings[0]),
            "a.xml:3:1: <extra> is not read; such elements are ignored");
  EXPECT_EQ(document.warnings[1].where.line, 4);
}

TEST(Orzan, warnings_are_capped_and_the_last_counts_the_rest) {
  std::string content;
  for (std::size_t i = 0; i < limits::kWarnings + 7; ++i) {
    content += "<kind" + std::to_string(i) + "/>";
  }
  const ReadDocument document = read(curve_set(content + "<curve>" + kPoints + "</curve>"));
  ASSERT_EQ(document.warnings.size(), limits::kWarnings + 1);
  EXPECT_EQ(document.warnings.back().message, "and 7 more of other kinds");
}

TEST(Orzan, document_without_curves_is_empty_with_a_warning) {
  const ReadDocument document = read("<curve_set image_width='3' image_height='2'/>");
  ASSERT_EQ(document.document.layers.size(), 1u);
  EXPECT_TRUE(document.document.layers[0].curves.empty());
  EXPECT_EQ(document.warnings.size(), 1u);
}

TEST(Orzan, byte_order_mark_moves_no_line) {
  const ReadDocument document = read("\xEF\xBB\xBF" + curve_set("<extra/>"));
  EXPECT_EQ(document.warnings.at(0).where.line, 3);
  EXPECT_EQ(document.warnings.at(0).where.column, 1);
}

TEST(Orzan, utf16_is_read_without_places) {
  std::string utf16 = "\xFF\xFE";
  for (const char c : curve_set("<extra/><curve>" + kPoints + "</curve>")) {
    utf16 += {c, '\0'};
  }
  const ReadDocument document = read(utf16);
  EXPECT_EQ(document.document.layers[0].curves.size(), 1u);
  EXPECT_EQ(to_string(document.warnings.at(0)),
            "a.xml: <extra> is not read; such elements are ignored");
}

TEST(Orzan, entities_of_a_doctype_are_expanded) {
  const std::string xml =
      "<!DOCTYPE curve_set [<!ENTITY width '3'><!ENTITY points \"" + kPoints +
      "\">]><curve_set image_width='&width;' image_height='2'><curve>&points;</curve></curve_set>";
  EXPECT_EQ(read(xml).document.layers[0].curves.size(), 1u);
}

TEST(OrzanScene, is_not_transposed_and_its_left_is_our_right) {
  const Curve curve = only_curve(
      "<scene image_width='30' image_height='20'><curve_set><curve>" + kPoints +
      "<left_colors_set><left_color R='255' G='51' B='0' globalID='0'/></left_colors_set>"
      "</curve></curve_set></scene>");
  EXPECT_EQ(curve.control_points[0], (Vec2{1, 2}));
  EXPECT_EQ(curve.left.color.kind, ShaderKind::open);
  ASSERT_EQ(curve.right.color.stops.stops.size(), 1u);
  EXPECT_EQ(curve.right.color.stops.stops[0].value, (Rgb{1, 0.2f, 0}));
}

}  // namespace
}  // namespace sfumato
