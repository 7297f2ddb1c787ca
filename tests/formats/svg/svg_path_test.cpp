// Path data and basic shapes as chains of cubics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

std::vector<Vec2> ends_of(const Curve& curve) {
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < curve.control_points.size(); i += 3) {
    ends.push_back(curve.control_points[i]);
  }
  return ends;
}

/// Returns the ends of the quarters of arcs.
std::vector<Vec2> quarters_of(const Curve& curve) {
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < curve.control_points.size(); i += 12) {
    ends.push_back(curve.control_points[i]);
  }
  return ends;
}

/// How far an arc may stray from its circle, in radii.
constexpr double kExact = 1.001e-7;

std::vector<Vec2> ends_of_path(const std::string& data) {
  return ends_of(curve_of_path(data));
}

Vec2 point_at(const Curve& curve, std::size_t piece, double t) {
  const Vec2* p = &curve.control_points[3 * piece];
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// Returns the largest difference between the curve's distance from a centre and the radius.
double radius_error(const Curve& curve, Vec2 center, double radius) {
  double error = 0;
  for (std::size_t piece = 0; piece < curve.piece_count(); ++piece) {
    for (int i = 0; i <= 16; ++i) {
      const double distance = length(point_at(curve, piece, i / 16.0) - center);
      error = std::max(error, std::abs(distance - radius));
    }
  }
  return error;
}

TEST(SvgPath, cubics_are_read_exactly) {
  expect_points(curve_of_path("M.1 .2 C.3 .4 .5 .6 .7 .8").control_points,
                {{.1, .2}, {.3, .4}, {.5, .6}, {.7, .8}}, 0);
}

TEST(SvgPath, line_is_a_cubic_with_its_points_at_thirds) {
  expect_points(curve_of_path("M0 0 L3 6").control_points, {{0, 0}, {1, 2}, {2, 4}, {3, 6}});
}

TEST(SvgPath, quadratic_is_raised_exactly) {
  const Curve curve = curve_of_path("M0 0 Q3 6 6 0");
  expect_points(curve.control_points, {{0, 0}, {2, 4}, {4, 4}, {6, 0}});
}

TEST(SvgPath, relative_commands_start_at_the_current_point) {
  expect_points(ends_of_path("m1 1 l1 0 h2 v3 c0 0 0 0 1 1 s0 0 2 2 q0 0 1 0 t1 0"),
                {{1, 1}, {2, 1}, {4, 1}, {4, 4}, {5, 5}, {7, 7}, {8, 7}, {9, 7}});
}

TEST(SvgPath, absolute_commands_are_the_same_in_capitals) {
  expect_points(ends_of_path("M1 1 L2 1 H4 V4 C4 4 4 4 5 5 S5 5 7 7 Q7 7 8 7 T9 7"),
                {{1, 1}, {2, 1}, {4, 1}, {4, 4}, {5, 5}, {7, 7}, {8, 7}, {9, 7}});
}

TEST(SvgPath, commands_repeat_without_their_letter) {
  expect_points(ends_of_path("M0 0 1 1 2 0"), {{0, 0}, {1, 1}, {2, 0}});
  expect_points(ends_of_path("m1 1 1 1 1-1"), {{1, 1}, {2, 2}, {3, 1}});
  expect_points(ends_of_path("M0 0 H1 2 V3 4"), {{0, 0}, {1, 0}, {2, 0}, {2, 3}, {2, 4}});
}

TEST(SvgPath, numbers_need_no_blanks_where_they_are_clear) {
  expect_points(ends_of_path("M.5.25-1-2,3e1+1E-1"), {{.5, .25}, {-1, -2}, {30, .1}});
}

TEST(SvgPath, smooth_cubic_mirrors_the_control_point_before) {
  const Curve curve = curve_of_path("M0 0 C0 1 1 2 2 2 S4 1 4 0");
  expect_points({curve.control_points[4]}, {{3, 2}});
}

TEST(SvgPath, smooth_cubic_after_another_command_starts_at_the_current_point) {
  const Curve curve = curve_of_path("M0 0 L2 2 S4 1 4 0");
  expect_points({curve.control_points[4]}, {{2, 2}});
}

TEST(SvgPath, smooth_quadratic_mirrors_the_control_point_before) {
  const Curve curve = curve_of_path("M0 0 Q1 3 2 0 T4 0 T6 0");
  expect_points(curve.control_points, {{0, 0},
                                       {2.0 / 3, 2},
                                       {4.0 / 3, 2},
                                       {2, 0},
                                       {8.0 / 3, -2},
                                       {10.0 / 3, -2},
                                       {4, 0},
                                       {14.0 / 3, 2},
                                       {16.0 / 3, 2},
                                       {6, 0}});
}

TEST(SvgPath, closed_subpath_ends_exactly_where_it_began) {
  const Curve curve = curve_of_path("m.1.1.1.2.3.1-.4-.3z");
  EXPECT_EQ(curve.control_points.front(), curve.control_points.back());
  EXPECT_EQ(curve.piece_count(), 3u);  // no tiny closing line from rounding
  EXPECT_EQ(curve_of_path("M0 0 H3 V3 Z").piece_count(), 3u);
}

TEST(SvgPath, each_subpath_is_a_curve) {
  const auto curves = curves_of("<path id='p' d='M0 0 H1 M5 5 H6 V7 z m1 1 h1'/>");
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].id, "p");
  EXPECT_EQ(curves[1].id, "p-2");
  expect_points(ends_of(curves[2]), {{6, 6}, {7, 6}});
}

TEST(SvgPath, a_subpath_of_no_length_is_left_out_with_a_warning) {
  for (const std::string dot : {"M9 9z", "M9 9h0", "M9 9h0z", "M9 9zz"}) {
    for (const std::string& path : {dot, "M1 1 H3 V3 Z" + dot, dot + "M1 1 H3 V3 Z"}) {
      const ReadDocument document = read(svg("<g sf:diffuse='true'><path sf:left='red' d='" + path +
                                             "'/><path sf:left='red' d='M1 1H3'/></g>"));
      EXPECT_EQ(document.document.layers.at(0).curves.size(), path == dot ? 1u : 2u) << path;
      ASSERT_EQ(document.warnings.size(), 1u) << path;
      EXPECT_NE(document.warnings[0].message.find("no length"), std::string::npos) << path;
    }
  }
}

TEST(SvgPath, command_after_a_closed_subpath_begins_at_its_start) {
  const auto curves = curves_of("<path d='M1 1 H3 V3 Z L5 5'/>");
  ASSERT_EQ(curves.size(), 2u);
  expect_points(ends_of(curves[1]), {{1, 1}, {5, 5}});
}

TEST(SvgPath, quarter_arc_is_four_pieces_on_the_circle) {
  const Curve curve = curve_of_path("M10 0 A10 10 0 0 1 0 10");
  EXPECT_EQ(curve.piece_count(), 4u);
  EXPECT_LT(radius_error(curve, {0, 0}, 10), kExact * 10);
}

TEST(SvgPath, short_arcs_take_fewer_pieces) {
  // 1, 7 and 40 degrees of a circle of radius 100 around the origin.
  for (const auto& [end, pieces] : {std::pair{"99.98476951563913 1.7452406437283512", 1u},
                                    std::pair{"99.25461516413220 12.186934340514748", 1u},
                                    std::pair{"76.60444431189780 64.27876096865393", 2u}}) {
    const Curve curve = curve_of_path("M100 0 A100 100 0 0 1 " + std::string(end));
    EXPECT_EQ(curve.piece_count(), pieces) << end;
    EXPECT_LT(radius_error(curve, {0, 0}, 100), kExact * 100) << end;
  }
}

TEST(SvgPath, the_four_arcs_between_two_points_are_told_apart) {
  const Vec2 near_center{10, 10}, far_center{0, 0};
  const auto arc = [](const char* flags) {
    return curve_of_path("M10 0 A10 10 0 " + std::string(flags) + " 0 10");
  };
  EXPECT_LT(radius_error(arc("0 1"), far_center, 10), kExact * 10);
  EXPECT_LT(radius_error(arc("1 0"), far_center, 10), kExact * 10);
  EXPECT_LT(radius_error(arc("0 0"), near_center, 10), kExact * 10);
  EXPECT_LT(radius_error(arc("1 1"), near_center, 10), kExact * 10);
  EXPECT_EQ(arc("0 0").piece_count(), 4u);
  EXPECT_EQ(arc("1 1").piece_count(), 16u);
}

TEST(SvgPath, half_arc_is_eight_pieces_through_the_right_side) {
  const Curve down = curve_of_path("M0 0 A5 5 0 0 1 0 10");
  EXPECT_EQ(down.piece_count(), 8u);
  expect_points({down.control_points[12]}, {{5, 5}});
  expect_points({curve_of_path("M0 0 A5 5 0 0 0 0 10").control_points[12]}, {{-5, 5}});
}

TEST(SvgPath, arc_whose_radii_are_too_small_is_scaled_up) {
  const Curve curve = curve_of_path("M0 0 A1 1 0 0 1 0 10");
  EXPECT_LT(radius_error(curve, {0, 5}, 5), kExact * 5);
}

TEST(SvgPath, turned_ellipse_passes_through_its_ends_and_axes) {
  // From an end of the long axis to an end of the short axis of an ellipse rotated by 30 degrees.
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const Curve curve = curve_of_path("M8.660254037844386 5 A10 4 30 0 1 -2 3.4641016151377544");
  EXPECT_EQ(curve.piece_count(), 4u);
  const Vec2 middle = curve.control_points[6];
  const Vec2 on_axes{c * middle.x + s * middle.y, c * middle.y - s * middle.x};
  EXPECT_NEAR(on_axes.x, 10 * std::sqrt(0.5), kExact * 10);
  EXPECT_NEAR(on_axes.y, 4 * std::sqrt(0.5), kExact * 10);
}

TEST(SvgPath, arc_of_no_radius_is_a_line) {
  expect_points(curve_of_path("M0 0 A0 5 0 0 1 3 6").control_points,
                {{0, 0}, {1, 2}, {2, 4}, {3, 6}});
}

TEST(SvgPath, flags_of_an_arc_need_no_blanks) {
  expect_points(quarters_of(curve_of_path("M10 0a10 10 0 01-10 10")), {{10, 0}, {0, 10}});
}

TEST(SvgShapes, line_polyline_and_polygon) {
  expect_points(ends_of(curve_of("<line x1='1' y1='2' x2='4' y2='8'/>")), {{1, 2}, {4, 8}});
  expect_points(ends_of(curve_of("<polyline points='0,0 1,1,2-0'/>")), {{0, 0}, {1, 1}, {2, 0}});
  expect_points(ends_of(curve_of("<polygon points='0 0 2 0 2 2'/>")),
                {{0, 0}, {2, 0}, {2, 2}, {0, 0}});
}

TEST(SvgShapes, circle_runs_clockwise_from_its_right_end) {
  const Curve curve = curve_of("<circle cx='20' cy='10' r='5'/>");
  expect_points(quarters_of(curve), {{25, 10}, {20, 15}, {15, 10}, {20, 5}, {25, 10}});
  EXPECT_EQ(curve.control_points.front(), curve.control_points.back());
  EXPECT_LT(radius_error(curve, {20, 10}, 5), kExact * 5);
}

TEST(SvgShapes, ellipse_takes_the_radius_that_is_left_out_from_the_other) {
  expect_points(quarters_of(curve_of("<ellipse cx='20' cy='10' rx='5' ry='2'/>")),
                {{25, 10}, {20, 12}, {15, 10}, {20, 8}, {25, 10}});
  expect_points(quarters_of(curve_of("<ellipse cx='20' cy='10' rx='5'/>")),
                {{25, 10}, {20, 15}, {15, 10}, {20, 5}, {25, 10}});
}

TEST(SvgShapes, rect_runs_clockwise_from_its_upper_left) {
  expect_points(ends_of(curve_of("<rect x='1' y='2' width='3' height='4'/>")),
                {{1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 2}});
}

TEST(SvgShapes, rounded_rect_has_arcs_at_its_corners) {
  const Curve curve = curve_of("<rect width='10' height='8' rx='2'/>");
  ASSERT_EQ(curve.piece_count(), 20u);
  std::vector<Vec2> ends;
  // A side, then a corner of four pieces.
  for (std::size_t side = 0; side < 4; ++side) {
    ends.push_back(curve.control_points[15 * side]);
    ends.push_back(curve.control_points[15 * side + 3]);
  }
  expect_points(ends, {{2, 0}, {8, 0}, {10, 2}, {10, 6}, {8, 8}, {2, 8}, {0, 6}, {0, 2}});
}

TEST(SvgShapes, radii_of_a_rect_are_at_most_half_of_it) {
  expect_points(quarters_of(curve_of("<rect width='10' height='8' rx='50' ry='50'/>")),
                {{5, 0}, {10, 4}, {5, 8}, {0, 4}, {5, 0}});
}

TEST(SvgShapes, lengths_have_units_and_percentages) {
  expect_points(ends_of(curve_of("<line x1='1in' y1='10%' x2='50%' y2='3pt'/>")),
                {{96, 5}, {50, 4}});
  expect_points(ends_of(curve_of("<line x1='1pc' y1='2px' x2='25.4mm' y2='2.54cm'/>")),
                {{16, 2}, {96, 96}}, 1e-10);
}

TEST(SvgShapes, what_has_no_length_is_left_out_with_a_warning) {
  const std::vector<std::string> warnings = warnings_of(
      svg_layer("<path sf:left='red' d='M1 1 M2 2 L2 2 M3 3 h1'/>\n<circle sf:left='red' r='0'/>"));
  EXPECT_EQ(curves_of("<path d='M1 1 M2 2 L2 2 M3 3 h1'/>").size(), 1u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "a.svg:3:1: <path> has a part of no length, or draws nothing; that is left out");
  EXPECT_TRUE(curves_of("<path d='none'/><path d=''/><path/><rect width='0' height='3'/>").empty());
}

}  // namespace
}  // namespace sfumato::test
