#include "curves/flatten.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curves/bezier.hpp"
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

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const double t = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
  return length(p - lerp(a, b, t));
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

TEST(Flatten, every_point_of_the_curve_is_within_the_tolerance) {
  for (double tolerance : {1.0, 0.1, 0.01}) {
    const Curve curve = arch();
    const FlatCurves flat = flattened({curve}, {.tolerance = tolerance});
    for (std::uint32_t v = 0; v + 1 < flat.vertex.size(); ++v) {
      for (int i = 0; i <= 10; ++i) {
        const double t = flat.parameter[v] + (flat.parameter[v + 1] - flat.parameter[v]) * i / 10;
        const Vec2 p = point_at(piece(curve.control_points, 0), t);
        EXPECT_LE(distance_to_segment(p, flat.vertex[v], flat.vertex[v + 1]), tolerance);
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

TEST(Flatten, outside_the_focus_the_coarser_tolerance_is_enough) {
  Curve far = arch();
  for (Vec2& p : far.control_points) p.x += 1000;
  const FlattenOptions options{
      .tolerance = 0.001, .focus = Box{{0, 0}, {100, 100}}, .outside_tolerance = 0.5};
  const FlatCurves flat = flattened({arch(), far}, options);
  EXPECT_GT(flat.curve_begin[1] - flat.curve_begin[0],
            4 * (flat.curve_begin[2] - flat.curve_begin[1]));
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

}  // namespace
}  // namespace sfumato::curves
