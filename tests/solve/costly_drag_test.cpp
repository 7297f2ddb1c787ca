#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "solve/diffused.hpp"
#include "solve/mean_difference.hpp"
#include "solve/solved.hpp"
#include "support/drawing.hpp"
#include "support/same_picture.hpp"

/// Drags of curves that cover much of a layer's mesh.
namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::difference_of;
using test::diffused;
using test::expecting_drags;
using test::kBlue;
using test::kGreen;
using test::kRed;
using test::kWhite;
using test::mean_difference;
using test::with_opacity;

/// Returns a closed curve with so many waves around a circle, of three pieces each.
Curve wavy_curve(Vec2 center, double radius, int waves) {
  Curve curve;
  const int points = 9 * waves;
  for (int i = 0; i <= points; ++i) {
    const double angle = 2 * std::numbers::pi * (i % points) / points;
    const double r = radius * (1 + 0.1 * std::sin(waves * angle));
    curve.control_points.push_back(center + Vec2{r * std::cos(angle), r * std::sin(angle)});
  }
  return curve;
}

Curve wave(Vec2 center = {50, 50}) {
  return colored(wavy_curve(center, 35, 12), kRed, kBlue);
}

Curve moved(Curve curve, Vec2 by) {
  for (Vec2& p : curve.control_points) p = p + by;
  return curve;
}

/// Returns a curve that is costly to drag, and one that is not.
Document drawing_of_costly(Curve costly) {
  return test::one_layer({std::move(costly), colored(circle_curve({50, 50}, 3), kBlue, kGreen)});
}

std::size_t triangles(const Solution& solution) {
  return solution.picture().layers[0].triangle_count();
}

TEST(CostlyDrag, has_a_mesh_that_is_rough_throughout) {
  Context context;
  Solution solution = expecting_drags(context, drawing_of_costly(wave()));
  const std::size_t exact = triangles(solution);
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  EXPECT_EQ(triangles(solution), exact) << "the picture stays as it is";
  for (const Vec2 by : {Vec2{1, 2}, Vec2{-3, 1}, Vec2{0, 0}}) {
    ASSERT_TRUE(solution.drag(context, {moved(wave(), by)}).ok());
    EXPECT_LT(triangles(solution), exact * 2 / 3);
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 1);
  }
  ASSERT_TRUE(solution.solve(context, {}).ok());
  EXPECT_EQ(triangles(solution), exact);
  EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
}

TEST(CostlyDrag, is_that_of_the_costly_curve_alone) {
  Context context;
  Solution solution = expecting_drags(context, drawing_of_costly(wave()));
  const std::size_t exact = triangles(solution);
  ASSERT_TRUE(solution.begin_drag(context, 0, {1}).ok());
  const Curve small = solution.document().layers[0].curves[1];
  ASSERT_TRUE(solution.drag(context, {moved(small, {2, 1})}).ok());
  EXPECT_GT(triangles(solution), exact * 9 / 10);
}

TEST(CostlyDrag, depends_on_where_the_curve_is_alone_beyond_the_picture_too) {
  Context context;
  Solution solution = expecting_drags(context, drawing_of_costly(wave()));
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {moved(wave(), {4, 3})}).ok());
  const Picture straight = solution.picture();
  for (const Vec2 by : {Vec2{-9, 5}, Vec2{40, 0}, Vec2{130, 20}, Vec2{900, 0}}) {
    ASSERT_TRUE(solution.drag(context, {moved(wave(), by)}).ok());
    EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 1) << by.x;
  }
  ASSERT_TRUE(solution.drag(context, {moved(wave(), {4, 3})}).ok());
  EXPECT_EQ(difference_of(solution.picture(), straight), "");
}

/// Returns the dragged curves, with their names.
std::vector<std::pair<std::string, Curve>> odd_curves() {
  std::vector<std::pair<std::string, Curve>> curves;
  Curve star = wave();  // some of its pieces cross each other
  for (std::size_t i = 0; i < star.control_points.size(); i += 36) {
    star.control_points[i] = Vec2{100, 100} - star.control_points[i];
  }
  star.control_points.back() = star.control_points.front();
  curves.emplace_back("crosses itself", star);
  Curve still = wave();  // includes pieces of no length
  for (std::size_t i = 1; i < 31; ++i) still.control_points[i] = still.control_points[0];
  curves.emplace_back("rests in a point", still);
  curves.emplace_back("fades", with_opacity(wave(), 0, 1));
  Curve opacity_only = wavy_curve({50, 50}, 35, 12);
  curves.emplace_back("bears opacity alone", with_opacity(opacity_only, 0.2f, 1));
  curves.emplace_back("is blurred", test::blurred(wave(), 4));
  Curve open = wave();
  open.control_points.resize(91);
  curves.emplace_back("is open", open);
  Curve one_piece;
  one_piece.control_points = {{50, 90}, {-90, -60}, {190, -60}, {50, 90}};
  curves.emplace_back("is one piece", colored(one_piece, kRed, kWhite));
  Curve point;
  point.control_points = {{40, 40}, {40, 40}, {40, 40}, {40, 40}};
  curves.emplace_back("is a point", colored(point, kRed, kWhite));
  return curves;
}

TEST(CostlyDrag, of_any_curve_shows_it_and_ends_in_the_picture_of_diffuse) {
  for (const auto& [name, curve] : odd_curves()) {
    SCOPED_TRACE(name);
    Context context;
    Document document = drawing_of_costly(curve);
    LayerInstance instance;  // a larger one beside the first
    instance.artboard_from_layer = {2, 0, 0, 2, 30, 10};
    document.stack.push_back(instance);
    Solution solution = expecting_drags(context, document);
    ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
    for (const Vec2 by : {Vec2{1, 2}, Vec2{-6, 1}, Vec2{150, 0}, Vec2{2, 2}}) {
      ASSERT_TRUE(solution.drag(context, {moved(curve, by)}, nullptr, 0).ok());
      ASSERT_TRUE(solution.drag_more(context).ok());
      EXPECT_EQ(solution.waiting_nodes(), 0u);
      EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 1.5) << by.x;
    }
    ASSERT_TRUE(solution.solve(context, {}).ok());
    EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
  }
}

/// Without its outline nothing in such a layer has an opacity.
TEST(CostlyDrag, waits_where_nothing_is_seen_without_the_curve) {
  Context context;
  const Curve outline = with_opacity(wave(), 0, 1);
  Solution solution = expecting_drags(context, drawing_of_costly(outline));
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {moved(outline, {1, 1})}, nullptr, 0).ok());
  ASSERT_TRUE(solution.drag_more(context).ok());
  DiffuseStats exact, hurried;
  ASSERT_TRUE(solution.drag(context, {moved(outline, {1.5, 1})}, &hurried, 0).ok());
  EXPECT_GT(solution.waiting_nodes(), 0u);
  EXPECT_LT(mean_difference(solution.picture(), diffused(solution.document())), 1.5);
  ASSERT_TRUE(solution.drag(context, {moved(outline, {1.5, 1})}, &exact).ok());
  EXPECT_EQ(solution.waiting_nodes(), 0u);
  EXPECT_LT(hurried.nodes, exact.nodes * 2 / 3);
}

}  // namespace
}  // namespace sfumato
