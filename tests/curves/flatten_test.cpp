#include "curves/flatten.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curves/bezier.hpp"
#include "curves/distance.hpp"
#include "support/drawing.hpp"
#include "support/scenes.hpp"

namespace sfumato::curves {
namespace {

Curve straight(Vec2 from, Vec2 to) {
  return {.control_points = {from, lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to}};
}

Curve arch() {
  return {.control_points = {{0, 0}, {0, 80}, {100, 80}, {100, 0}}};
}

FlatCurves flattened(std::vector<Curve> curves, FlattenOptions options = {}) {
  Context context;
  Result<FlatCurves> flat = flatten(context, curves, options);
  EXPECT_TRUE(flat.ok());
  return *flat;
}

TEST(Flatten, a_straight_line_of_constant_speed_is_one_segment) {
  const FlatCurves flat = flattened({straight({0, 0}, {90, 30})});
  EXPECT_EQ(flat.vertex.size(), 2u);
  EXPECT_EQ(flat.segment_count(), 1u);
}

TEST(Flatten, a_straight_line_of_uneven_speed_keeps_its_parameter) {
  // Control points at the ends: the speed is 0 there, and the middle third passes quickly.
  const Curve line{.control_points = {{0, 0}, {0, 0}, {90, 0}, {90, 0}}};
  const FlatCurves flat = flattened({line});
  EXPECT_GT(flat.segment_count(), 4u);
  for (std::size_t v = 0; v < flat.vertex.size(); ++v) {
    EXPECT_EQ(flat.vertex[v], point_at(piece(line.control_points, 0), flat.parameter[v]));
  }
}

TEST(Flatten, bows_are_the_heights_of_the_curve_over_its_chords) {
  Curve curve = arch();
  curve.left.color.stops = {StopSpace::parameter, {{0, {}}, {0.3f, {}}, {0.55f, {}}}};
  const FlatCurves flat = flattened({curve}, {.tolerance = 0.5, .keeps_bows = true});
  ASSERT_GE(flat.bow.size() + 1, flat.vertex.size());
  for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
    const Vec2 from = flat.vertex[v], chord = flat.vertex[v + 1] - from;
    const Vec2 normal = Vec2{-chord.y, chord.x} / length(chord);
    for (int i = 0; i <= 10; ++i) {
      const double t = flat.parameter[v] + (flat.parameter[v + 1] - flat.parameter[v]) * i / 10;
      const Vec2 p = point_at(piece(curve.control_points, 0), t) - from;
      const double u = dot(p, chord) / dot(chord, chord);
      EXPECT_NEAR(flat.bow[v].at(u), dot(p, normal), 0.02) << v << ' ' << i;
    }
  }
}

TEST(Flatten, chords_at_free_ends_stay_fine_where_bows_are_kept) {
  const FlatCurves fine = flattened({arch()}, {.tolerance = 0.04});
  const FlatCurves coarse = flattened({arch()}, {.tolerance = 0.2, .keeps_bows = true});
  const auto first = [](const FlatCurves& flat) { return length(flat.vertex[1] - flat.vertex[0]); };
  EXPECT_LT(coarse.segment_count(), fine.segment_count());
  EXPECT_LT(first(coarse), 1.3 * first(fine));
}

TEST(Flatten, chords_stray_less_beside_another_curve) {
  const auto arc = [](double y) {
    return Curve{.control_points = {{0, y}, {30, y + 40}, {70, y + 40}, {100, y}}};
  };
  const FlattenOptions options{.tolerance = 0.2, .reach = 1e-4, .keeps_bows = true};
  const std::size_t alone = flattened({arc(0)}, options).segment_count();
  EXPECT_GE(2 * flattened({arc(0), arc(0.3)}, options).segment_count(), 5 * alone);
  EXPECT_EQ(flattened({arc(0), arc(20)}, options).segment_count(), 2 * alone);
  // Curves that coincide have the chords of one.
  EXPECT_EQ(flattened({arc(0), arc(0)}, options).segment_count(), 2 * alone);
}

TEST(Flatten, every_point_of_the_curve_is_within_the_tolerance) {
  for (double tolerance : {1.0, 0.1, 0.01}) {
    const Curve curve = arch();
    const FlatCurves flat = flattened({curve}, {.tolerance = tolerance});
    for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
      for (int i = 0; i <= 10; ++i) {
        const double t = flat.parameter[v] + (flat.parameter[v + 1] - flat.parameter[v]) * i / 10;
        const Vec2 p = point_at(piece(curve.control_points, 0), t);
        EXPECT_LE(test::distance_to_segment(p, flat.vertex[v], flat.vertex[v + 1]), tolerance);
      }
    }
  }
}

TEST(Flatten, a_tenth_of_the_tolerance_needs_about_three_times_the_segments) {
  const double coarse =
      static_cast<double>(flattened({arch()}, {.tolerance = 0.1}).segment_count());
  const double fine = static_cast<double>(flattened({arch()}, {.tolerance = 0.01}).segment_count());
  EXPECT_GT(fine / coarse, 2);
  EXPECT_LT(fine / coarse, 5);
}

TEST(Flatten, every_stop_is_a_vertex) {
  Curve curve = straight({0, 0}, {100, 0});
  curve.left.color.kind = ShaderKind::curve_domain;
  curve.left.color.stops.stops = {{0.0, {}}, {0.3, {}}, {1.0, {}}};
  curve.right.blur_radius.stops = {{0.125, 1.0f}};
  const FlatCurves flat = flattened({curve});
  for (double stop : {0.0, 0.125, 0.3, 1.0}) {
    EXPECT_TRUE(std::find(flat.parameter.begin(), flat.parameter.end(), stop) !=
                flat.parameter.end())
        << stop;
  }
}

TEST(Flatten, stops_in_arc_length_stand_at_their_length) {
  Curve curve{.control_points = {{0, 0}, {0, 0}, {90, 0}, {90, 0}}};
  curve.left.color.kind = ShaderKind::curve_domain;
  curve.left.color.stops = {StopSpace::arc_length, {{0.25, {}}}};
  const FlatCurves flat = flattened({curve});
  const bool found = std::any_of(flat.vertex.begin(), flat.vertex.end(),
                                 [](Vec2 p) { return std::fabs(p.x - 22.5) < 1e-5; });
  EXPECT_TRUE(found);
}

Curve with_stops(Curve curve, std::vector<double> offsets) {
  curve.left.color.kind = ShaderKind::curve_domain;
  for (double offset : offsets) curve.left.color.stops.stops.push_back({offset, {}});
  return curve;
}

/// Returns a chain of two pieces that bends both ways, smooth where they meet.
Curve wave() {
  return {
      .control_points = {{0, 0}, {0, 60}, {70, 90}, {100, 40}, {130, -10}, {180, 0}, {200, 50}}};
}

Curve reversed(Curve curve) {
  std::reverse(curve.control_points.begin(), curve.control_points.end());
  return curve;
}

/// Returns the part of one piece of a curve from t0 to t1.
Curve stretch_of(const Curve& curve, std::size_t index, double t0, double t1) {
  const Cubic part = subcurve(piece(curve.control_points, index), t0, t1);
  return {.control_points = {part.begin(), part.end()}};
}

std::vector<Vec2> vertices_of(const FlatCurves& flat, std::uint32_t curve) {
  return {flat.vertex.begin() + flat.curve_begin[curve],
          flat.vertex.begin() + flat.curve_begin[curve + 1]};
}

double distance_to_polyline(Vec2 p, const std::vector<Vec2>& polyline) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    least = std::min(least, test::distance_to_segment(p, polyline[i], polyline[i + 1]));
  }
  return least;
}

/// Returns the largest distance of vertices of two polylines from the other one, along their common
/// part.
double distance_between(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0;
  for (Vec2 p : b) most = std::max(most, distance_to_polyline(p, a));
  for (Vec2 p : a) {
    const double t0 = length(p - b.front()), t1 = length(p - b.back());
    const double d = distance_to_polyline(p, b);
    // Vertices beyond the end of a shorter one are closest to that end.
    if (d < std::min(t0, t1)) most = std::max(most, d);
  }
  return most;
}

TEST(Flatten, a_stop_lies_on_the_chord_that_is_there_without_it) {
  const std::vector<Vec2> plain = vertices_of(flattened({wave()}), 0);
  const FlatCurves flat = flattened({with_stops(wave(), {0, 0.01, 0.3, 0.3, 1.234, 1.9, 2})});
  EXPECT_EQ(flat.vertex.size(), plain.size() + 4);
  for (Vec2 p : plain) EXPECT_EQ(std::ranges::count(flat.vertex, p), 1);
  for (Vec2 p : flat.vertex) EXPECT_LT(distance_to_polyline(p, plain), 1e-12);
}

TEST(Flatten, stops_so_close_that_they_share_a_chord_keep_their_order) {
  std::vector<double> offsets;
  for (int i = 0; i <= 400; ++i) offsets.push_back(i / 200.0);
  const FlatCurves flat = flattened({with_stops(wave(), offsets)}, {.tolerance = 5});
  for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
    EXPECT_LT(flat.parameter[v], flat.parameter[v + 1]);
    EXPECT_LE(flat.arc_length[v], flat.arc_length[v + 1]);
  }
}

TEST(Flatten, equal_curves_have_one_polyline_whatever_their_stops_and_blur) {
  Curve soft = with_stops(wave(), {0, 0.77, 2});
  soft.right.color = soft.left.color;
  soft.right.color.stops.stops[1].value = {1, 1, 1};
  soft.right.blur_radius.stops = {{0, 1.0f}, {2, 9.0f}};
  const FlatCurves flat = flattened({wave(), soft, reversed(wave())}, {.reach = 0.01});
  for (std::uint32_t a = 0; a < 3; ++a) {
    for (std::uint32_t b = 0; b < 3; ++b) {
      EXPECT_LT(distance_between(vertices_of(flat, a), vertices_of(flat, b)), 1e-9) << a << b;
    }
  }
}

TEST(Flatten, a_stretch_of_a_curve_lies_on_its_chords) {
  for (double tolerance : {2.0, 0.1, 0.002}) {
    for (const auto& [t0, t1] : {std::pair{0.0, 1.0}, {0.1, 0.9}, {0.31, 0.47}, {0.5, 0.500001}}) {
      const FlatCurves flat = flattened(
          {wave(), stretch_of(wave(), 1, t0, t1), reversed(stretch_of(wave(), 1, t0, t1))},
          {.tolerance = tolerance, .reach = 0.01});
      for (std::uint32_t b : {1u, 2u}) {
        EXPECT_LT(distance_between(vertices_of(flat, 0), vertices_of(flat, b)), 0.01)
            << tolerance << " " << t0;
      }
    }
  }
}

TEST(Flatten, copies_that_rounding_moved_have_chords_within_the_reach) {
  Curve rounded = wave();
  for (Vec2& p : rounded.control_points) p = p + Vec2{0.003, -0.004};
  const FlatCurves flat = flattened({wave(), rounded}, {.tolerance = 0.5, .reach = 0.02});
  EXPECT_LT(distance_between(vertices_of(flat, 0), vertices_of(flat, 1)), 0.02);
}

TEST(Flatten, a_curve_that_folds_back_has_one_polyline_for_both_passages) {
  Curve folded = wave();
  const Curve back = reversed(wave());
  folded.control_points.insert(folded.control_points.end(), back.control_points.begin() + 1,
                               back.control_points.end());
  const FlatCurves flat = flattened({folded}, {.reach = 0.01});
  const auto turn =
      static_cast<std::size_t>(std::ranges::find(flat.parameter, 2.0) - flat.parameter.begin());
  const std::vector<Vec2> out(flat.vertex.begin(), flat.vertex.begin() + turn + 1);
  const std::vector<Vec2> home(flat.vertex.begin() + turn, flat.vertex.end());
  EXPECT_LT(distance_between(out, home), 1e-9);
}

TEST(Flatten, an_end_that_touches_a_curve_touches_its_chords) {
  for (double t : {0.02, 0.2, 0.5, 0.77}) {
    const Vec2 on = point_at(piece(wave().control_points, 0), t);
    const FlatCurves flat =
        flattened({wave(), straight(on, {40, -60})}, {.tolerance = 0.5, .reach = 0.01});
    EXPECT_LT(distance_to_polyline(on, vertices_of(flat, 0)), 0.01) << t;
    EXPECT_EQ(vertices_of(flat, 1).front(), on);
  }
}

TEST(Flatten, ends_and_corners_stay_where_they_are) {
  Curve corner = arch();
  for (Vec2 p : {Vec2{130, 30}, {160, 30}, {190, 0}}) corner.control_points.push_back(p);
  const FlatCurves flat = flattened({corner}, {.tolerance = 1});
  EXPECT_EQ(flat.vertex.front(), (Vec2{0, 0}));
  EXPECT_EQ(std::ranges::count(flat.vertex, Vec2{100, 0}), 1);
  EXPECT_EQ(flat.vertex.back(), (Vec2{190, 0}));
}

TEST(Flatten, a_straight_edge_beside_an_arc_stays_where_it_is) {
  const Curve corner{.control_points = {{0, 0},
                                        {30, 0},
                                        {60, 0},
                                        {90, 0},
                                        {100, 0},
                                        {110, 10},
                                        {110, 20},
                                        {110, 40},
                                        {110, 60},
                                        {110, 80}}};
  const FlatCurves flat = flattened({corner});
  ASSERT_GT(flat.vertex.size(), 4u);
  for (std::size_t v = 0; v < flat.vertex.size(); ++v) {
    const bool is_before = flat.parameter[v] <= 1, is_after = flat.parameter[v] >= 2;
    EXPECT_TRUE(!is_before || flat.vertex[v].y == 0) << v;
    EXPECT_TRUE(!is_after || flat.vertex[v].x == 110) << v;
  }
}

TEST(Flatten, a_circle_keeps_its_area) {
  const Curve circle = test::circle_curve({50, 50}, 40);
  for (double tolerance : {1.0, 0.1}) {
    const FlatCurves flat = flattened({circle}, {.tolerance = tolerance});
    EXPECT_EQ(flat.vertex.front(), flat.vertex.back());
    double twice_area = 0, perimeter = 0;
    for (std::size_t v = 0; v + 1 < flat.vertex.size(); ++v) {
      twice_area += cross(flat.vertex[v] - Vec2{50, 50}, flat.vertex[v + 1] - Vec2{50, 50});
      perimeter += length(flat.vertex[v + 1] - flat.vertex[v]);
    }
    // The mean distance of the chords inside the circle; the cubics lie 2.7e-4 of the radius
    // outside.
    const double inside = (3.14159265 * 1600 - std::fabs(twice_area) / 2) / perimeter;
    EXPECT_NEAR(inside, 0, 0.006 + 0.05 * tolerance);
  }
}

TEST(Flatten, where_it_is_blurred_a_steep_curve_is_flattened_finer) {
  Curve steep = with_stops(arch(), {0});
  steep.right.color = {ShaderKind::curve_domain, {StopSpace::parameter, {{0, {1, 1, 1}}}}};
  const std::size_t sharp = flattened({steep}).segment_count();
  steep.left.blur_radius.stops = {{0, 2.0f}};
  const std::size_t soft = flattened({steep}).segment_count();
  EXPECT_GT(soft, sharp + sharp / 2);
  steep.right.color.stops.stops[0].value = {0.01f, 0, 0};
  EXPECT_EQ(flattened({steep}).segment_count(), sharp);
}

TEST(Flatten, curves_without_number_on_one_place_take_no_square_of_time) {
  std::vector<Curve> curves(5'000, arch());
  EXPECT_GT(flattened(curves, {.tolerance = 1, .reach = 0.01}).segment_count(), 20'000u);
}

TEST(Flatten, far_outside_the_focus_chords_stray_by_a_share_of_their_distance) {
  Curve far = arch();
  for (Vec2& p : far.control_points) p.x += 20;
  for (const double side : {1.0, 1e-3, 1e-7, 1e-300}) {
    const double tolerance = side / 5120;
    const FlatCurves flat =
        flattened({far}, {.focuses = {{Box{{0, 0}, {side, side}}, tolerance, tolerance}}});
    EXPECT_LT(flat.segment_count(), 200u) << side;
    for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
      const double middle = 0.5 * (flat.parameter[v] + flat.parameter[v + 1]);
      const Vec2 p = point_at(piece(far.control_points, 0), std::min(middle, 1.0));
      EXPECT_LE(test::distance_to_segment(p, flat.vertex[v], flat.vertex[v + 1]),
                std::max(tolerance, length(p) / 16384));
    }
  }
}

TEST(Flatten, outside_the_focus_the_coarser_tolerance_is_enough) {
  Curve far = arch();
  for (Vec2& p : far.control_points) p.x += 1000;
  const FlattenOptions options{.focuses = {{Box{{0, 0}, {100, 100}}, 0.001, 0.5}}};
  const FlatCurves flat = flattened({arch(), far}, options);
  EXPECT_GT(flat.curve_begin[1] - flat.curve_begin[0],
            4 * (flat.curve_begin[2] - flat.curve_begin[1]));
}

TEST(Flatten, of_many_focuses_the_finest_counts_where_it_looks) {
  const Box near{{0, 0}, {20, 20}};
  const auto count = [&](const FlattenOptions& options) {
    return flattened({arch()}, options).segment_count();
  };
  const std::size_t coarse = count({.focuses = {{near, 0.1, 0.1}}});
  const std::size_t fine = count({.focuses = {{near, 1e-4, 1e-4}}});
  ASSERT_GT(fine, 4 * coarse);
  EXPECT_EQ(count({.focuses = {{near, 0.1, 0.1}, {near, 1e-4, 1e-4}}}), fine);
  // A request for a distant place needs hardly more chords, however fine it is.
  const Box far{{1e4, 1e4}, {1e4 + 1e-6, 1e4 + 1e-6}};
  EXPECT_EQ(count({.focuses = {{near, 0.1, 0.1}, {far, 1e-12, 1e-12}}}), coarse);
}

TEST(Flatten, a_piece_of_no_length_is_harmless) {
  const Curve speck{.control_points = {{5, 5}, {5, 5}, {5, 5}, {5, 5}, {6, 5}, {7, 5}, {8, 5}}};
  const FlatCurves flat = flattened({speck});
  EXPECT_EQ(flat.vertex.back(), (Vec2{8, 5}));
  EXPECT_EQ(flat.parameter.back(), 2.0);
}

TEST(Flatten, more_segments_than_the_limit_is_an_error) {
  std::vector<Curve> curves(700, arch());
  Context context;
  const Result<FlatCurves> flat = flatten(context, curves, {.tolerance = 1e-9});
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.status().code, StatusCode::limit);
}

TEST(Flatten, a_cancelled_context_stops) {
  Context context;
  context.cancel = true;
  const std::vector<Curve> curves{arch()};
  EXPECT_EQ(flatten(context, curves, {}).status().code, StatusCode::cancelled);
}

TEST(Flatten, the_lady_bug_has_about_1400_segments) {
  const std::optional<Document> document = test::shared_scene("lady_bug.xml");
  if (!document) GTEST_SKIP() << "the shared scenes are not here";
  const FlatCurves flat = flattened(document->layers[0].curves);
  EXPECT_GT(flat.segment_count(), 1200u);
  EXPECT_LT(flat.segment_count(), 1900u);
}

/// Returns a closed curve with a tip at {60, 80}: a handle lies in the tip, so that vertices gather
/// there.
Curve tip_of_a_corner_node() {
  return {.control_points = {{54, 66},
                             {55, 71},
                             {60, 80},
                             {60, 80},
                             {57.6, 76.6},
                             {55.2, 73.2},
                             {52, 68.6},
                             {52.7, 67.7},
                             {53.3, 66.9},
                             {54, 66}}};
}

bool has_vertex_near(const FlatCurves& flat, Vec2 tip, double from, double to) {
  return std::ranges::any_of(flat.vertex, [&](Vec2 v) {
    const double distance = length(v - tip);
    return distance > from && distance < to;
  });
}

constexpr double kTipReach = 0.034;

TEST(Flatten, sides_of_an_outline_have_no_vertices_within_reach_of_each_other_at_a_tip) {
  Curve curve = tip_of_a_corner_node();
  for (int i = 0; i < 2; ++i) {
    const FlatCurves flat = flattened({curve}, {.tolerance = 0.025, .reach = kTipReach});
    EXPECT_EQ(std::ranges::count(flat.vertex, Vec2{60, 80}), 1);
    EXPECT_FALSE(has_vertex_near(flat, {60, 80}, 0, 0.3));
    EXPECT_TRUE(has_vertex_near(flat, {60, 80}, 0.3, 2));
    std::ranges::reverse(curve.control_points);
  }
}

TEST(Flatten, a_tip_at_the_joint_of_an_outline_is_like_any_other) {
  Curve curve = tip_of_a_corner_node();
  std::vector<Vec2>& points = curve.control_points;
  std::rotate(points.begin(), points.begin() + 3, points.end() - 1);
  points.back() = points.front();
  const FlatCurves flat = flattened({curve}, {.tolerance = 0.025, .reach = kTipReach});
  EXPECT_EQ(flat.vertex.front(), flat.vertex.back());
  EXPECT_FALSE(has_vertex_near(flat, {60, 80}, 0, 0.3));
}

/// Returns a closed curve whose sides leave the tip at `kCuspTip` in one direction.
Curve cusp() {
  return {.control_points = {{117.189, 60.185},
                             {120.689, 58.015},
                             {124.982, 53.87},
                             {129.518, 55.365},
                             {132.526, 56.357},
                             {135.921, 61.442},
                             {134.785, 64.742},
                             {135.681, 62.136},
                             {130.06, 57.244},
                             {127.811, 57.244},
                             {125.244, 57.245},
                             {117.421, 60.042},
                             {117.189, 60.185}}};
}

constexpr Vec2 kCuspTip{134.785, 64.742};

/// Returns the least distance of a vertex near the tip from the chords on the other side of it.
double width_near(const FlatCurves& flat, std::size_t tip) {
  double least = INFINITY;
  for (std::size_t v = 0; v < flat.vertex.size(); ++v) {
    if (v == tip || length(flat.vertex[v] - flat.vertex[tip]) > 2) continue;
    for (std::size_t s = 0; s + 1 < flat.vertex.size(); ++s) {
      const bool is_other_side = v < tip ? s >= tip : s < tip;
      if (!is_other_side) continue;
      const double width =
          test::distance_to_segment(flat.vertex[v], flat.vertex[s], flat.vertex[s + 1]);
      least = std::min(least, width);
    }
  }
  return least;
}

TEST(Flatten, sides_that_leave_a_tip_in_one_direction_keep_apart) {
  for (int width_px = 100; width_px <= 1000; width_px += 25) {
    Curve curve = cusp();
    const double pixel = 136.612 / width_px, reach = std::min(136.612 / 1024, pixel) / 16;
    const FlattenOptions options{.tolerance = std::min(136.612 * 0.05 / 512, 0.04 * pixel),
                                 .reach = reach};
    for (int i = 0; i < 2; ++i) {
      const FlatCurves flat = flattened({curve}, options);
      const auto tip = std::ranges::find(flat.vertex, kCuspTip);
      ASSERT_NE(tip, flat.vertex.end());
      const auto index = static_cast<std::size_t>(tip - flat.vertex.begin());
      EXPECT_GT(width_near(flat, index), reach / 2) << width_px << " pixels";
      std::ranges::reverse(curve.control_points);
    }
  }
}

/// It keeps the vertices of the curve, because either side may show at the tip.
TEST(Flatten, a_curve_of_several_paints_keeps_its_vertices_at_a_tip) {
  Curve curve = tip_of_a_corner_node();
  curve.left.opacity.stops.stops = {{0, 1}, {1, 0}};
  const FlatCurves flat = flattened({curve}, {.tolerance = 0.025, .reach = kTipReach});
  EXPECT_TRUE(has_vertex_near(flat, {60, 80}, 0, 0.3));
}

}  // namespace
}  // namespace sfumato::curves
