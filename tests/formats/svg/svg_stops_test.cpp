// Stop lists and the attributes of curves.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

/// Returns the stops on a path of four segments.
ColorStops left_of(const std::string& list) {
  return curve_of("<path d='M0 0 H1 H2 H3 H4' sf:left='" + list + "'/>").left.color.stops;
}

std::vector<double> offsets_of_list(const std::string& list) {
  std::vector<double> offsets;
  for (const auto& stop : left_of(list).stops) offsets.push_back(stop.offset);
  return offsets;
}

using Offsets = std::vector<double>;

TEST(SvgStops, one_colour_is_constant) {
  const ColorStops stops = left_of("#f00");
  ASSERT_EQ(stops.stops.size(), 1u);
  EXPECT_EQ(stops.stops[0], (Stop<Rgb>{0, {1, 0, 0}}));
}

TEST(SvgStops, missing_offsets_are_spread_evenly) {
  EXPECT_EQ(offsets_of_list("red, lime"), (Offsets{0, 1}));
  EXPECT_EQ(offsets_of_list("red, lime, blue"), (Offsets{0, .5, 1}));
  EXPECT_EQ(offsets_of_list("red, lime, blue 80%, white"), (Offsets{0, .4, .8, 1}));
  EXPECT_EQ(offsets_of_list("red 20%, lime, blue, white 50%"), (Offsets{.2, .2 + .3 / 3, .4, .5}));
}

TEST(SvgStops, percentages_count_arc_length_and_segments_the_parameter) {
  EXPECT_EQ(left_of("red, lime 30%").space, StopSpace::arc_length);
  const ColorStops stops = left_of("red @0, lime @2.5");
  EXPECT_EQ(stops.space, StopSpace::parameter);
  EXPECT_EQ(stops.stops[1].offset, 2.5);
}

TEST(SvgStops, in_a_list_with_segments_percentages_count_segments_too) {
  EXPECT_EQ(offsets_of_list("red, lime 50%, blue @3, white"), (Offsets{0, 2, 3, 4}));
}

TEST(SvgStops, same_offset_twice_is_a_step) {
  EXPECT_EQ(offsets_of_list("red 50%, lime 50%"), (Offsets{.5, .5}));
}

TEST(SvgStops, stops_that_go_back_are_moved_to_the_largest_so_far) {
  EXPECT_EQ(offsets_of_list("red 60%, lime 20%, blue 10%, white 70%"), (Offsets{.6, .6, .6, .7}));
  EXPECT_EQ(offsets_of_list("red @3, lime, blue @1"), (Offsets{3, 3, 3}));
}

TEST(SvgStops, colours_with_commas_and_blanks_are_one_value) {
  const ColorStops stops = left_of(" rgb(255, 0, 0) 10% ,hsl(120 100% 50%)\n 90% ");
  ASSERT_EQ(stops.stops.size(), 2u);
  EXPECT_EQ(stops.stops[0], (Stop<Rgb>{.1, {1, 0, 0}}));
  EXPECT_EQ(stops.stops[1], (Stop<Rgb>{.9, {0, 1, 0}}));
}

TEST(SvgStops, lists_apply_to_each_subpath) {
  const auto curves = curves_of("<path d='M0 0 H1 H2 M0 5 h1' sf:left='red @0, lime @1'/>");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].left, curves[1].left);
}

TEST(SvgStops, stop_beyond_the_last_segment_is_moved_there_with_a_warning) {
  EXPECT_EQ(offsets_of_list("red @1, lime @7"), (Offsets{1, 4}));
  EXPECT_EQ(warnings_of(svg_layer("<path d='M0 0 h1' sf:left='red @7'/>"))[0],
            "a.svg:3:1: a stop of <path> lies beyond the last segment; it is moved to the end");
}

TEST(SvgStops, an_arc_of_several_pieces_is_one_segment) {
  // A line, then a half circle of eight pieces.
  const Curve curve = curve_of(
      "<path d='M0 0 H5 A5 5 0 0 1 5 10' sf:left='red @.5, lime @1, blue @1.75, white @2'/>");
  ASSERT_EQ(curve.piece_count(), 9u);
  const auto& stops = curve.left.color.stops.stops;
  EXPECT_EQ(stops[0].offset, .5);
  EXPECT_EQ(stops[1].offset, 1);
  EXPECT_EQ(stops[2].offset, 7);
  EXPECT_EQ(stops[3].offset, 9);
}

TEST(SvgSides, absent_is_open_and_none_is_a_barrier) {
  const Curve curve = curve_of("<path d='M0 0 h1' sf:right='none' sf:left-opacity='none'/>");
  EXPECT_EQ(curve.left.color.kind, ShaderKind::open);
  EXPECT_EQ(curve.right.color.kind, ShaderKind::barrier);
  EXPECT_EQ(curve.left.opacity.kind, ShaderKind::barrier);
  EXPECT_EQ(curve.right.opacity.kind, ShaderKind::open);
}

TEST(SvgSides, attributes_for_both_sides_yield_to_those_of_one) {
  const Curve curve = curve_of(
      "<path d='M0 0 h1' sf:opacity='0, 1' sf:left-opacity='.25' sf:blur='3 0%, 4 40%' "
      "sf:right-blur='0'/>");
  ASSERT_EQ(curve.left.opacity.stops.stops.size(), 1u);
  EXPECT_EQ(curve.left.opacity.stops.stops[0].value, .25f);
  EXPECT_EQ(curve.right.opacity.stops.stops.size(), 2u);
  ASSERT_EQ(curve.left.blur_radius.stops.size(), 2u);
  EXPECT_EQ(curve.left.blur_radius.stops[1], (Stop<float>{.4, 4}));
  EXPECT_TRUE(curve.right.blur_radius.empty()) << "0 is sharp";
}

TEST(SvgSides, weight_is_read) {
  EXPECT_EQ(curve_of("<path d='M0 0 h1'/>").weight, 1);
  EXPECT_EQ(curve_of("<path d='M0 0 h1' sf:weight=' 2.5 '/>").weight, 2.5);
}

TEST(SvgLocalCurves, take_colours_radii_blur_and_alpha) {
  const ReadDocument document =
      read(svg("<path id='shine' d='M160 105 Q170 95 185 100' sf:left='#fff' sf:right='red, lime' "
               "sf:radius='3, 14 50%, 3' sf:blur='1' sf:alpha='.8'/>"));
  ASSERT_EQ(document.document.stack.size(), 1u);
  const LocalCurve& curve = std::get<LocalStroke>(document.document.stack[0]).curve;
  EXPECT_EQ(curve.id, "shine");
  EXPECT_EQ(curve.left_color.stops.size(), 1u);
  EXPECT_EQ(curve.right_color.stops.size(), 2u);
  ASSERT_EQ(curve.influence_radius.stops.size(), 3u);
  EXPECT_EQ(curve.influence_radius.stops[1], (Stop<float>{.5, 14}));
  EXPECT_EQ(curve.blur_radius.stops[0].value, 1);
  EXPECT_EQ(curve.alpha, .8);
}

TEST(SvgLocalCurves, side_without_colours_has_the_others) {
  const ReadDocument document = read(svg("<path d='M0 0 h9' sf:right='lime' sf:radius='3'/>"));
  const LocalCurve& curve = std::get<LocalStroke>(document.document.stack[0]).curve;
  EXPECT_EQ(curve.left_color, curve.right_color);
}

}  // namespace
}  // namespace sfumato::test
