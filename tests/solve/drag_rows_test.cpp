#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "sfumato/solve/solution.hpp"
#include "solve/circles.hpp"
#include "solve/diffused.hpp"
#include "solve/solved.hpp"
#include "support/drawing.hpp"
#include "support/same_picture.hpp"

/// The rows of a layer's tables that the frames of a drag change.
namespace sfumato {
namespace {

using test::circle_at;
using test::circles;
using test::colored;
using test::difference_of;
using test::diffused;
using test::expecting_drags;
using test::kGreen;
using test::kRed;

TEST(DragRows, says_the_rows_between_pictures_that_were_looked_at) {
  Context context;
  Solution solution = expecting_drags(context, circles());
  ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({41, 37})}).ok());
  ASSERT_TRUE(solution.drag(context, {circle_at({44, 37})}).ok());
  const PatchLayer before = solution.picture().layers[0];
  EXPECT_TRUE(solution.take_delta().rows.empty()) << "it is new as a whole";
  for (const Vec2 center : {Vec2{47, 37}, Vec2{30, 44}, Vec2{45, 36}})
    ASSERT_TRUE(solution.drag(context, {circle_at(center)}).ok());
  const PictureDelta delta = solution.take_delta();
  ASSERT_EQ(delta.layers, std::vector<std::uint32_t>{0});
  ASSERT_EQ(delta.rows.size(), 1u);
  const PatchLayer& after = solution.picture().layers[0];
  const LayerRows& rows = delta.rows[0];
  const auto common = std::min(before.triangle_count(), after.triangle_count());
  for (std::uint32_t t = 0; t < common; ++t) {
    if (std::ranges::binary_search(rows.triangles, t)) continue;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      ASSERT_EQ(before.triangle_vertex[h], after.triangle_vertex[h]) << t;
  }
  for (std::uint32_t t = common; t < after.triangle_count(); ++t)
    ASSERT_TRUE(std::ranges::binary_search(rows.triangles, t)) << t;
  EXPECT_LT(rows.triangles.size(), after.triangle_count());
}

/// Returns the rows of a table with `width` columns from `first` on, or the listed ones.
template <class Item>
void bring_up(const std::vector<Item>& from, std::size_t width, std::size_t first,
              std::span<const std::uint32_t> rows, std::vector<Item>& table) {
  table.resize(from.size());
  const auto copy = [&](std::size_t row) {
    if (width * row < from.size()) {
      std::copy_n(from.data() + width * row, width, table.data() + width * row);
    }
  };
  for (std::size_t row = first; width * row < from.size(); ++row) copy(row);
  for (const std::uint32_t row : rows) copy(row);
}

/// Expects that the rows suffice to turn one layer into the other.
void expect_enough(PatchLayer layer, const LayerRows& rows, const PatchLayer& after) {
  constexpr std::size_t kNone = 0xffffffff;
  bring_up(after.vertex_position, 1, rows.first_vertex, {}, layer.vertex_position);
  bring_up(after.triangle_vertex, 3, kNone, rows.triangles, layer.triangle_vertex);
  bring_up(after.edge_is_curve, 3, kNone, rows.triangles, layer.edge_is_curve);
  for (const auto field : {&PatchLayer::color, &PatchLayer::opacity}) {
    const auto channels = static_cast<std::size_t>((after.*field).channel_count);
    if (channels == 0) continue;
    bring_up((after.*field).triangle_node, kNodesPerTriangle, kNone, rows.triangles,
             (layer.*field).triangle_node);
    bring_up((after.*field).node_value, channels, kNone,
             field == &PatchLayer::color ? rows.nodes : rows.opacity_nodes,
             (layer.*field).node_value);
  }
  layer.soft_edge = after.soft_edge;
  Picture brought, made;
  brought.layers.push_back(std::move(layer));
  made.layers.push_back(after);
  EXPECT_EQ(difference_of(brought, made), "");
}

TEST(DragRows, says_the_rows_of_its_first_frame_too) {
  Context context;
  Document document = circles();
  const Curve line = colored(test::straight_curve({60, 60}, {68, 63}), kRed, kGreen);
  document.layers[0].curves.push_back(line);
  Solution solution = expecting_drags(context, document);
  solution.take_delta();
  const PatchLayer solved = solution.picture().layers[0];
  ASSERT_TRUE(solution.begin_drag(context, 0, {2}).ok());
  Curve moved = line;
  moved.control_points[0] = {57, 58};
  ASSERT_TRUE(solution.drag(context, {moved}).ok());
  const PictureDelta delta = solution.take_delta();
  ASSERT_EQ(delta.rows.size(), 1u);
  expect_enough(solved, delta.rows[0], solution.picture().layers[0]);
  EXPECT_LT(delta.rows[0].triangles.size(), solved.triangle_count());
}

TEST(DragRows, says_the_rows_of_layers_that_have_opacity) {
  for (const bool is_joint : {false, true}) {
    SCOPED_TRACE(is_joint);
    Context context;
    Document document = circles();
    for (std::size_t i = 0; i < document.layers[0].curves.size(); ++i) {
      if (i > 0 && !is_joint) continue;
      Curve& curve = document.layers[0].curves[i];
      curve = test::with_opacity(curve, 0.5f, i == 0 ? 0 : 1);
    }
    const auto placed = [&](Vec2 center) {
      Curve curve = document.layers[0].curves[0];
      curve.control_points = circle_at(center).control_points;
      return curve;
    };
    Solution solution = expecting_drags(context, document);
    ASSERT_TRUE(solution.begin_drag(context, 0, {0}).ok());
    ASSERT_TRUE(solution.drag(context, {placed({41, 37})}).ok());
    solution.take_delta();
    const PatchLayer before = solution.picture().layers[0];
    for (const Vec2 center : {Vec2{47, 37}, Vec2{30, 44}, Vec2{45, 36}})
      ASSERT_TRUE(solution.drag(context, {placed(center)}).ok());
    const PictureDelta delta = solution.take_delta();
    const PatchLayer& after = solution.picture().layers[0];
    ASSERT_EQ(delta.rows.size(), 1u);
    expect_enough(before, delta.rows[0], after);
    EXPECT_LT(delta.rows[0].triangles.size(), after.triangle_count());
    ASSERT_TRUE(solution.solve(context, {}).ok());
    EXPECT_EQ(difference_of(solution.picture(), diffused(solution.document())), "");
  }
}

}  // namespace
}  // namespace sfumato
