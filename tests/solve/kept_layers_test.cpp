#include "solve/layers/kept_layers.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "solve/circles.hpp"
#include "solve/diffused.hpp"
#include "solve/solved.hpp"
#include "support/drawing.hpp"
#include "support/same_picture.hpp"

// Data reserved for drags in many layers (Solution::expect_drags, with a bound).

namespace sfumato {
namespace {

using solve::KeptLayer;
using solve::layers_beyond;
using test::circle_at;
using test::circle_curve;
using test::colored;
using test::difference_of;
using test::diffused;
using test::kBlue;
using test::kGreen;
using test::one_layer;
using test::solution_of;
using Indices = std::vector<std::uint32_t>;

TEST(KeptLayers, the_last_ones_that_were_dragged_come_first_and_then_the_largest) {
  const std::vector<KeptLayer> layers = {{0, 0, 50}, {1, 0, 90}, {2, 1, 60}, {3, 7, 40}};
  EXPECT_EQ(layers_beyond(layers, 240), Indices{});
  EXPECT_EQ(layers_beyond(layers, 239), (Indices{0}));
  EXPECT_EQ(layers_beyond(layers, 150), (Indices{1}));
  EXPECT_EQ(layers_beyond(layers, 99), (Indices{2, 1}));
  EXPECT_EQ(layers_beyond({}, 0), Indices{});
}

TEST(KeptLayers, the_last_one_that_was_dragged_stays_in_any_case) {
  EXPECT_EQ(layers_beyond({{0, 0, 5}, {1, 2, 90}, {2, 1, 60}}, 0), (Indices{2, 0}));
  EXPECT_EQ(layers_beyond({{0, 0, 5}, {1, 0, 90}}, 0), (Indices{1, 0}));
}

/// Returns so many layers of two circles.
Document layers_of_circles(std::uint32_t count) {
  const std::vector<Curve> two = {circle_at({30, 30}),
                                  colored(circle_curve({50, 50}, 45), kBlue, kGreen)};
  Document document = one_layer(two);
  for (std::uint32_t i = 1; i < count; ++i) {
    document.layers.push_back(document.layers[0]);
    document.stack.push_back(LayerInstance{i, {}, 0.5f});
  }
  return document;
}

std::size_t kept_bytes(const Document& document, std::size_t most_triangles) {
  Context context;
  Solution solution = solution_of(context, document);
  solution.expect_drags(most_triangles);
  EXPECT_TRUE(solution.solve(context, {}).ok());
  return context.budget.used() - bytes_of(solution.document()) - bytes_of(solution.picture());
}

TEST(KeptLayers, a_bound_on_triangles_bounds_memory) {
  const Document three = layers_of_circles(3);
  const std::size_t triangles = diffused(three).layers[0].triangle_count();
  const std::size_t one = kept_bytes(layers_of_circles(1), 1'000'000);
  EXPECT_GT(one, 300 * triangles);
  EXPECT_GT(kept_bytes(three, 1'000'000), 5 * one / 2);
  EXPECT_LT(kept_bytes(three, 2 * triangles), 5 * one / 2);
  EXPECT_LT(kept_bytes(three, triangles), 3 * one / 2);
  EXPECT_LT(kept_bytes(three, triangles - 1), one / 2);
  EXPECT_GT(kept_bytes(layers_of_circles(1), 0), one / 2) << "it is the only layer";
}

TEST(KeptLayers, drags_do_not_depend_on_what_was_kept) {
  Context context, other;
  Solution kept = solution_of(context, layers_of_circles(3));
  Solution bounded = solution_of(other, layers_of_circles(3));
  kept.expect_drags();
  bounded.expect_drags(0);
  ASSERT_TRUE(kept.solve(context, {}).ok());
  ASSERT_TRUE(bounded.solve(other, {}).ok());
  for (const std::uint32_t layer : {2u, 0u, 2u}) {
    ASSERT_TRUE(kept.begin_drag(context, layer, {0}).ok());
    ASSERT_TRUE(bounded.begin_drag(other, layer, {0}).ok());
    EXPECT_EQ(difference_of(bounded.picture(), diffused(bounded.document())), "") << layer;
    for (const double x : {41.0, 44.0 + layer}) {
      ASSERT_TRUE(kept.drag(context, {circle_at({x, 37})}).ok());
      ASSERT_TRUE(bounded.drag(other, {circle_at({x, 37})}).ok());
      EXPECT_EQ(difference_of(bounded.picture(), kept.picture()), "") << layer;
    }
    ASSERT_TRUE(kept.solve(context, {}).ok());
    ASSERT_TRUE(bounded.solve(other, {}).ok());
    EXPECT_EQ(difference_of(bounded.picture(), diffused(bounded.document())), "") << layer;
  }
}

}  // namespace
}  // namespace sfumato
