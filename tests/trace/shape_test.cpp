// Radii of blur, ends that meet other curves, and shapes that move to the edges.
#include "trace/curves/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "trace/curves/snap.hpp"
#include "trace/image/blur_estimate.hpp"
#include "trace/planes_of.hpp"
#include "trace/traced_curves.hpp"

namespace sfumato::tracing {
namespace {

double estimated_radius(double sigma, double scale) {
  const Plane plane =
      test::plane_of(80, 60, [&](Vec2 p) { return 0.5 * test::blurred_step(p.x - 40.2, sigma); });
  TracedCurve curve = test::traced(test::straight_curve({40.2, 5}, {40.2, 55}));
  curve.scale = scale;
  Context context;
  const Status status =
      estimate_blur(context, std::span(&plane, 1), std::span<TracedCurve>(&curve, 1));
  EXPECT_TRUE(status.ok()) << to_string(status);
  return curve.radius;
}

TEST(EstimateBlur, finds_the_radius_of_a_blurred_edge) {
  for (const double sigma : {1.0, 2.0, 4.0}) {
    EXPECT_NEAR(estimated_radius(sigma, std::max(1.0, sigma / 2)), 1.88 * sigma,
                0.25 * 1.88 * sigma)
        << sigma;
  }
}

TEST(EstimateBlur, says_that_a_sharp_edge_is_sharp) {
  EXPECT_EQ(estimated_radius(0, 1), 0);
}

TEST(EstimateBlur, leaves_the_frame_alone) {
  const Plane plane = test::plane_of(40, 30, [](Vec2 p) { return p.x / 40; });
  TracedCurve frame = frame_of(40, 30);
  Context context;
  ASSERT_TRUE(estimate_blur(context, std::span(&plane, 1), std::span<TracedCurve>(&frame, 1)).ok());
  EXPECT_EQ(frame.radius, 0);
}

/// Returns the line x = 50 and a curve that comes from the left and ends at (x, 50).
std::vector<TracedCurve> line_and_end(double x, double rise = 0) {
  return {test::traced(test::straight_curve({50, 10}, {50, 90})),
          test::traced(test::straight_curve({10, 50 - rise}, {x, 50}))};
}

std::vector<TracedCurve> snapped(std::vector<TracedCurve> curves) {
  Context context;
  EXPECT_TRUE(snap_to_curves(context, 100, 100, {0.08f}, curves).ok());
  return curves;
}

TEST(SnapToCurves, leads_an_end_onto_the_curve_ahead) {
  for (const double short_by : {0.3, 1.0, 3.0}) {
    for (const double rise : {0.0, 15.0}) {
      const TracedCurve curve = snapped(line_and_end(50 - short_by, rise))[1];
      EXPECT_NEAR(curve.control_points.back().x, 50, 1e-6) << short_by;
      EXPECT_NEAR(curve.control_points.back().y, 50, 2) << short_by;
      EXPECT_EQ(curve.control_points.front(), (Vec2{10, 50 - rise}));
      for (const CurveSample& sample : samples_along(curve, 0.25)) {
        EXPECT_LE(sample.point.x, 50 + 1e-6) << short_by;
      }
    }
  }
}

TEST(SnapToCurves, leads_the_beginning_as_well_as_the_end) {
  std::vector<TracedCurve> curves = line_and_end(48.5);
  std::ranges::reverse(curves[1].control_points);
  curves = snapped(curves);
  EXPECT_NEAR(curves[1].control_points.front().x, 50, 1e-6);
  EXPECT_EQ(curves[1].control_points.back(), (Vec2{10, 50}));
}

TEST(SnapToCurves, leaves_ends_alone_that_are_far_or_leak_nothing) {
  EXPECT_EQ(snapped(line_and_end(44))[1].control_points.back(), (Vec2{44, 50}));
  std::vector<TracedCurve> even = line_and_end(49);
  even[1].side[1] = even[1].side[0];
  EXPECT_EQ(snapped(even)[1].control_points.back(), (Vec2{49, 50}));
}

/// The colours above and below the curve from the left may then differ.
TEST(SnapToCurves, gives_the_side_on_which_an_end_lands_a_step) {
  for (const bool is_mirrored : {false, true}) {
    std::vector<TracedCurve> curves = line_and_end(49);
    if (is_mirrored) {
      for (Vec2& p : curves[1].control_points) p.x = 100 - p.x;
    }
    const TracedCurve line = snapped(curves)[0];
    // The line runs down: on its right is the left of the picture.
    const SideStops& lands = line.side[is_mirrored ? 0 : 1];
    ASSERT_EQ(lands.place.size(), 4u);
    EXPECT_EQ(lands.place[1], lands.place[2]);
    EXPECT_NEAR(lands.place[1], 0.5, 0.01);
    EXPECT_EQ(lands.value[1], lands.value[0]);
    EXPECT_EQ(line.side[is_mirrored ? 1 : 0].place.size(), 2u);
  }
}

/// Its parameter counts sides of the picture, which are long.
TEST(SnapToCurves, gives_the_frame_steps_for_ends_that_are_near_each_other) {
  std::vector<TracedCurve> curves{frame_of(1000, 1000)};
  for (const double x : {9.0, 500.6, 510.3}) {
    curves.push_back(test::traced(test::straight_curve({x, 300}, {x, 1})));
  }
  for (SideStops& side : curves[0].side) {
    side = {{0, 1, 2, 3, 4}, std::vector<SideValue>(5, {0, 0, 0, 1})};
  }
  curves[0].side[0] = {};
  Context context;
  ASSERT_TRUE(snap_to_curves(context, 1000, 1000, {0.08f}, curves).ok());
  std::vector<double> at;
  const std::vector<double>& places = curves[0].side[1].place;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] == places[i - 1]) at.push_back(point_on(curves[0], places[i]).x);
  }
  ASSERT_EQ(at.size(), 3u);
  EXPECT_NEAR(at[0], 9, 0.1);
  EXPECT_NEAR(at[1], 500.6, 0.1);
  EXPECT_NEAR(at[2], 510.3, 0.1);
}

TEST(SnapToCurves, gives_one_step_to_a_place_however_often_it_is_called) {
  const std::vector<TracedCurve> once = snapped(line_and_end(49));
  EXPECT_EQ(snapped(once)[0].side[1].place.size(), 4u);
}

/// Returns, for a disc drawn `off` from its place in the picture, the largest distance of its
/// border from the true one after its shape was improved `turns` times.
double miss_of_disc(Vec2 off, int turns) {
  const Vec2 center{32.3, 31.8};
  const double radius = 20;
  Curve circle = test::circle_curve(center + off, radius);
  std::vector<TracedCurve> curves{test::traced(circle)};
  for (int turn = 0; turn < turns; ++turn) {
    // The inside is on the right and has colour 1; the drawn picture follows from the curve itself.
    const std::vector<CurveSample> border = samples_along(curves[0], 0.5);
    const auto drawn = [&](Vec2 p) {
      const auto near = std::ranges::min_element(
          border, {}, [&](const CurveSample& s) { return length(s.point - p); });
      return test::cover(-dot(p - near->point, near->left));
    };
    const Plane missing = test::plane_of(
        64, 64, [&](Vec2 p) { return test::cover(radius - length(p - center)) - drawn(p); });
    Context context;
    const std::vector<Plane> planes(3, missing);
    EXPECT_TRUE(improve_shapes(context, planes, curves).ok());
  }
  double most = 0;
  for (const CurveSample& sample : samples_along(curves[0], 0.5)) {
    most = std::max(most, std::fabs(length(sample.point - center) - radius));
  }
  EXPECT_EQ(curves[0].control_points.front(), curves[0].control_points.back());
  return most;
}

TEST(ImproveShapes, moves_a_disc_to_its_place) {
  for (const Vec2 off : {Vec2{0.7, 0}, Vec2{0, -0.7}, Vec2{0.5, 0.5}}) {
    EXPECT_GT(miss_of_disc(off, 0), 0.65);
    EXPECT_LT(miss_of_disc(off, 1), 0.1) << off.x << ' ' << off.y;
    EXPECT_LT(miss_of_disc(off, 2), 0.05) << off.x << ' ' << off.y;
  }
}

TEST(ImproveShapes, leaves_a_disc_that_is_right) {
  EXPECT_LT(miss_of_disc({0, 0}, 1), 0.02);
}

/// Returns an arc whose handles are at this height, for a picture without errors.
TracedCurve arc_with_handles_at(double y) {
  Curve arc;
  arc.control_points = {{5, 30}, {5, y}, {55, y}, {55, 30}};
  std::vector<TracedCurve> curves{test::traced(arc)};
  const std::vector<Plane> missing(3, test::plane_of(60, 60, [](Vec2) { return 0; }));
  Context context;
  EXPECT_TRUE(improve_shapes(context, missing, curves).ok());
  return curves[0];
}

TEST(ImproveShapes, leaves_handles_outside_the_picture_to_arcs_within) {
  EXPECT_EQ(arc_with_handles_at(-8).control_points[1], (Vec2{5, -8}));
  EXPECT_EQ(arc_with_handles_at(-8).control_points[2], (Vec2{55, -8}));
}

TEST(ImproveShapes, keeps_curves_within_the_picture) {
  for (const CurveSample& sample : samples_along(arc_with_handles_at(-30), 0.5)) {
    EXPECT_GE(sample.point.y, 0);
  }
}

TEST(ImproveShapes, leaves_the_frame_alone) {
  const std::vector<Plane> missing(3, test::plane_of(40, 30, [](Vec2 p) { return p.x / 40; }));
  std::vector<TracedCurve> frame{frame_of(40, 30)};
  Context context;
  ASSERT_TRUE(improve_shapes(context, missing, frame).ok());
  EXPECT_EQ(frame[0].control_points, frame_of(40, 30).control_points);
}

}  // namespace
}  // namespace sfumato::tracing
