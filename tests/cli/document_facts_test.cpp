#include "cli/commands/document_facts.hpp"

#include <gtest/gtest.h>

namespace sfumato::cli {
namespace {

const Box kSquare{{0, 0}, {10, 10}};

Curve curve_through(std::vector<Vec2> points) {
  Curve made;
  made.control_points = std::move(points);
  return made;
}

TEST(Leaves, is_false_where_only_control_points_are_outside) {
  // Its highest point is y = 3/4 · 12 = 9.
  EXPECT_FALSE(leaves(curve_through({{0, 0}, {2, 12}, {8, 12}, {10, 0}}), kSquare));
}

TEST(Leaves, finds_the_bulge_between_two_ends_inside) {
  // Its highest point is y = 3/4 · 14 = 10.5.
  EXPECT_TRUE(leaves(curve_through({{0, 0}, {2, 14}, {8, 14}, {10, 0}}), kSquare));
  EXPECT_TRUE(leaves(curve_through({{1, 5}, {-3, 5}, {-3, 6}, {1, 6}}), kSquare));
}

TEST(Leaves, finds_the_bulge_of_a_quadratic_where_the_cubic_term_is_zero) {
  // y = 21 t (1 - t) in cubic form: the middle is at 5.25, and twice that height leaves the square.
  EXPECT_FALSE(leaves(curve_through({{0, 0}, {3, 7}, {6, 7}, {9, 0}}), {{0, 0}, {10, 5.26}}));
  EXPECT_TRUE(leaves(curve_through({{0, 0}, {3, 7}, {6, 7}, {9, 0}}), {{0, 0}, {10, 5.24}}));
}

TEST(Leaves, looks_at_every_piece) {
  EXPECT_FALSE(
      leaves(curve_through({{1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {7, 1}}), kSquare));
  EXPECT_TRUE(
      leaves(curve_through({{1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {11, 1}}), kSquare));
}

TEST(CountFacts, adds_up_all_layers) {
  Curve closed = curve_through({{1, 1}, {2, 1}, {2, 2}, {1, 1}});
  closed.left.color.stops.stops = {{0, {}}, {1, {}}};
  closed.right.color.stops.stops = {{0, {}}};
  closed.right.blur_radius.stops = {{0, 0.0f}, {1, 2.0f}};
  Curve open = curve_through({{1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 1}, {11, 1}});
  open.left.blur_radius.stops = {{0, 0.0f}};
  Document document;
  document.artboard = kSquare;
  document.layers = {{"", {closed, open}}, {"", {closed}}};
  LayerInstance aside;
  aside.artboard_from_layer = {1, 0, 0, 1, -5, 0};
  document.stack = {LayerInstance{}, aside};
  const DocumentFacts facts = count_facts(document);
  EXPECT_EQ(facts.layers, 2u);
  EXPECT_EQ(facts.curves, 3u);
  EXPECT_EQ(facts.closed_curves, 2u);
  EXPECT_EQ(facts.bezier_pieces, 4u);
  EXPECT_EQ(facts.control_points, 15u);
  EXPECT_EQ(facts.color_stops, 6u);
  EXPECT_EQ(facts.blurred_curves, 2u);
  EXPECT_EQ(facts.leaving_curves, 1u);
  EXPECT_EQ(facts.instances, 2u);
  EXPECT_EQ(facts.bare_curves, 3u);
}

}  // namespace
}  // namespace sfumato::cli
