#include <gtest/gtest.h>

#include "gather/scene/scene.hpp"
#include "gather/scenes.hpp"

namespace sfumato::gather::test {
namespace {

/// A diamond of two triangles, above and below an edge from vertex 0 (left) to 1 (right) along the
/// x axis. y is down: the triangle of half-edge 0 is below, on its right.
struct Diamond {
  mesh::TriangleMesh mesh;
  curves::SegmentAttributes attributes;

  static constexpr std::uint32_t kBelow = 0;  ///< half-edge 0 → 1
  static constexpr std::uint32_t kAbove = 3;  ///< half-edge 1 → 0

  Diamond() {
    mesh.lattice_step = 1;
    mesh.vertex_position = {{0, 0}, {4, 0}, {2, 2}, {2, -2}};
    mesh.triangle_vertex = {0, 1, 2, 1, 0, 3};
    mesh.half_edge_twin = {3, -1, -1, 0, -1, -1};
    mesh.half_edge_constraint = {0, -1, -1, 0, -1, -1};
    mesh.constraint = {{0, 1, 0, 0}};
  }

  /// Adds a segment of a separate curve over the edge; in the opposite direction if `reversed`.
  void add(curves::SegmentSide left, curves::SegmentSide right, bool reversed = false,
           float weight = 1) {
    const auto segment = static_cast<std::uint32_t>(attributes.weight.size());
    attributes.left.insert(attributes.left.end(), {left, {}});
    attributes.right.insert(attributes.right.end(), {right, {}});
    attributes.weight.insert(attributes.weight.end(), {weight, weight});
    attributes.vertex.insert(attributes.vertex.end(),
                             {reversed ? Vec2{4, 0} : Vec2{0, 0}, reversed ? Vec2{} : Vec2{4, 0}});
    attributes.curve.insert(attributes.curve.end(), {segment / 2, segment / 2});
    mesh.piece.push_back({segment, reversed ? 1.0f : 0.0f, reversed ? 0.0f : 1.0f});
    mesh.constraint[0].piece_end = static_cast<std::uint32_t>(mesh.piece.size());
  }

  Facing facing(std::uint32_t half_edge) const { return facing_side(mesh, attributes, half_edge); }
};

constexpr Rgb kRed{1, 0, 0}, kGreen{0, 1, 0}, kBlue{0, 0, 1};

curves::SegmentSide color(Rgb from, Rgb to) {
  return {ShaderKind::curve_domain, 0, {from, to}};
}
const curves::SegmentSide kOpen{};
const curves::SegmentSide kBarrier{ShaderKind::barrier, 0, {}};

TEST(Facing, a_curve_along_the_half_edge_shows_its_right) {
  Diamond diamond;
  diamond.add(color(kRed, kGreen), color(kBlue, kWhite));
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kBlue);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).to, kWhite);
  // The half-edge above runs from right to left and shows the left of the curve.
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kGreen);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).to, kRed);
}

TEST(Facing, a_curve_against_the_constraint_shows_its_left_below) {
  Diamond diamond;
  diamond.add(color(kRed, kGreen), color(kBlue, kWhite), true);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kGreen);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).to, kRed);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kBlue);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).to, kWhite);
}

TEST(Facing, colours_are_those_at_the_pieces_own_fractions) {
  Diamond diamond;
  diamond.add(kOpen, color(kRed, kGreen));
  diamond.mesh.piece[0].u_from = 0.25f;
  diamond.mesh.piece[0].u_to = 0.5f;
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, (Rgb{0.75f, 0.25f, 0}));
  EXPECT_EQ(diamond.facing(Diamond::kBelow).to, (Rgb{0.5f, 0.5f, 0}));
}

TEST(Facing, the_piece_drawn_last_wins) {
  Diamond diamond;
  diamond.add(color(kRed, kRed), color(kRed, kRed), false, 2);
  diamond.add(color(kBlue, kBlue), color(kGreen, kGreen), false, 3);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kGreen);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).weight, 3);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kBlue);
}

TEST(Facing, of_a_curve_that_folds_back_the_last_passage_wins) {
  Diamond diamond;
  diamond.add(color(kRed, kRed), color(kGreen, kGreen));
  diamond.add(color(kBlue, kBlue), color(kWhite, kWhite), true);
  diamond.attributes.curve.assign(4, 0);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kBlue);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kWhite);
}

TEST(Facing, of_passages_that_were_apart_the_outer_one_wins) {
  Diamond diamond;
  diamond.add(color(kRed, kRed), color(kGreen, kGreen));
  diamond.add(color(kBlue, kBlue), color(kWhite, kWhite), true);
  diamond.attributes.curve.assign(4, 0);
  // Before the weld the first curve ran below the second.
  for (Vec2* p : {&diamond.attributes.vertex[0], &diamond.attributes.vertex[1]}) p->y += 1.5;
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kGreen);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kWhite);
}

TEST(Facing, an_open_side_leaves_the_edge_to_the_piece_below) {
  Diamond diamond;
  diamond.add(color(kRed, kRed), color(kWhite, kWhite), false, 2);
  diamond.add(color(kBlue, kBlue), kOpen, false, 3);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).from, kWhite);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).weight, 2);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).from, kBlue);
}

TEST(Facing, a_barrier_drawn_last_hides_the_colour_below) {
  Diamond diamond;
  diamond.add(color(kRed, kRed), color(kWhite, kWhite));
  diamond.add(kOpen, kBarrier);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).kind, ShaderKind::barrier);
  EXPECT_EQ(diamond.facing(Diamond::kAbove).kind, ShaderKind::curve_domain);
}

TEST(Facing, an_edge_of_the_frame_or_open_on_a_side_is_open) {
  Diamond diamond;
  EXPECT_EQ(diamond.facing(Diamond::kBelow).kind, ShaderKind::open);
  diamond.add(kOpen, color(kRed, kRed));
  EXPECT_EQ(diamond.facing(Diamond::kAbove).kind, ShaderKind::open);
}

TEST(Facing, an_image_domain_side_keeps_its_shader) {
  Diamond diamond;
  diamond.add(kOpen, {ShaderKind::image_domain, 5, {}});
  EXPECT_EQ(diamond.facing(Diamond::kBelow).kind, ShaderKind::image_domain);
  EXPECT_EQ(diamond.facing(Diamond::kBelow).shader, 5u);
}

TEST(Scene, edges_are_stops_borders_or_passages) {
  Diamond diamond;
  diamond.add(kOpen, color(kRed, kGreen), false, 4);
  Context context;
  const Result<Scene> scene = build_scene(context, diamond.mesh, diamond.attributes);
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene->origin, (Vec2{2, 0}));
  ASSERT_EQ(scene->hit_edge.size(), 1u);
  // In the scene's order the triangle above (of smaller y) comes first.
  EXPECT_EQ(scene->triangle[1].edge[0], hit_code(0));
  EXPECT_EQ(scene->triangle[1].edge[1], kBorder);
  EXPECT_EQ(scene->triangle[1].twin[0], 0);
  // From above a ray passes, to the triangle below.
  EXPECT_EQ(scene->triangle[0].edge[0], 0);
  ASSERT_EQ(scene->edge_beyond.size(), 1u);
  EXPECT_EQ(scene->edge_beyond[0].apex_x, 0);
  EXPECT_EQ(scene->edge_beyond[0].apex_y, 2);
  EXPECT_EQ(scene->edge_beyond[0].right, kBorder);
  EXPECT_EQ(scene->edge_beyond[0].left, kBorder);
  const HitEdge& stop = scene->hit_edge[0];
  EXPECT_EQ(stop.ax, -2);
  EXPECT_EQ(stop.bx, 2);
  EXPECT_EQ(stop.weight, 1);
  EXPECT_EQ(stop.length_squared, 16);
  EXPECT_EQ(stop.middle[0], 0.5f);
  EXPECT_EQ(stop.half_change[0], -0.5f);
  EXPECT_EQ(stop.half_change[1], 0.5f);
}

TEST(Scene, barriers_are_borders_to_the_exact_gather) {
  Diamond diamond;
  diamond.add(kBarrier, kBarrier);
  Context context;
  const Result<Scene> scene = build_scene(context, diamond.mesh, diamond.attributes);
  ASSERT_TRUE(scene.ok());
  EXPECT_TRUE(scene->hit_edge.empty());
  EXPECT_EQ(scene->triangle[0].edge[0], kBorder);
  EXPECT_EQ(scene->triangle[1].edge[0], kBorder);
}

}  // namespace
}  // namespace sfumato::gather::test
