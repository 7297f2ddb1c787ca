#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/flat_input.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

struct Meshes {
  TriangleMesh visibility;
  TriangleMesh patch;
};

Meshes meshes_of(const curves::FlatCurves& flat, const MeshOptions& options = options_100()) {
  Context context;
  Result<Mesher> mesher = Mesher::build(context, flat, options);
  EXPECT_TRUE(mesher.ok()) << mesher.status().message;
  Meshes meshes{*mesher->visibility_mesh({}), {}};
  EXPECT_TRUE(mesher->refine(context).ok());
  meshes.patch = *mesher->patch_mesh({});
  EXPECT_TRUE(is_valid(meshes.visibility).ok()) << is_valid(meshes.visibility).message;
  EXPECT_TRUE(is_valid(meshes.patch).ok()) << is_valid(meshes.patch).message;
  EXPECT_NEAR(total_area(meshes.patch), options.frame.width() * options.frame.height(), 1e-6);
  return meshes;
}

std::size_t curve_constraint_count(const TriangleMesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.constraint.begin(), mesh.constraint.end(),
                    [](const Constraint& c) { return c.piece_begin < c.piece_end; }));
}

TEST(Mesher, without_curves_the_frame_alone_is_meshed) {
  const Meshes meshes = meshes_of(flat_curves({}));
  EXPECT_EQ(meshes.visibility.constraint.size(), 4u);
  EXPECT_EQ(meshes.patch.triangle_count(), 2u);
  EXPECT_TRUE(meshes.patch.piece.empty());
}

TEST(Mesher, a_segment_is_one_constraint_from_end_to_end) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {70, 40}}}));
  const auto c = constraint_between(meshes.visibility, {20, 30}, {70, 40});
  ASSERT_TRUE(c);
  ASSERT_EQ(meshes.visibility.pieces(*c).size(), 1u);
  const auto pieces = pieces_of_segment(meshes.visibility, 0);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].from, (Vec2{20, 30}));
  EXPECT_EQ(pieces[0].to, (Vec2{70, 40}));
  EXPECT_EQ(pieces[0].u_from, 0);
  EXPECT_EQ(pieces[0].u_to, 1);
}

TEST(Mesher, subdivided_constraints_keep_linear_fractions_of_their_segment) {
  // The point beside the segment makes refinement split the segment.
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {84, 30}}, {{50, 31}, {50, 34}}}));
  const auto pieces = pieces_of_segment(meshes.patch, 0);
  ASSERT_GT(pieces.size(), 2u);
  float reached = 0;
  for (const PlacedPiece& piece : pieces) {
    EXPECT_EQ(piece.u_from, reached);
    reached = piece.u_to;
    EXPECT_NEAR(piece.from.x, 20 + 64 * piece.u_from, 2 * meshes.patch.lattice_step);
    EXPECT_EQ(piece.from.y, 30);
  }
  EXPECT_EQ(reached, 1);
}

TEST(Mesher, a_crossing_becomes_a_vertex_with_fractions_on_both) {
  const Meshes meshes = meshes_of(flat_curves({{{10, 50}, {90, 50}}, {{30, 20}, {30, 80}}}));
  const auto across = pieces_of_segment(meshes.visibility, 0);
  const auto down = pieces_of_segment(meshes.visibility, 2);
  ASSERT_EQ(across.size(), 2u);
  ASSERT_EQ(down.size(), 2u);
  EXPECT_EQ(across[0].to, (Vec2{30, 50}));
  EXPECT_EQ(across[0].u_to, 0.25f);
  EXPECT_EQ(across[1].u_from, 0.25f);
  EXPECT_EQ(down[0].to, (Vec2{30, 50}));
  EXPECT_EQ(down[0].u_to, 0.5f);
  EXPECT_EQ(down[1].u_from, 0.5f);
}

TEST(Mesher, an_oblique_crossing_is_found_to_within_the_lattice) {
  const Meshes meshes = meshes_of(flat_curves({{{10, 10}, {80, 73}}, {{15, 70}, {77, 12}}}));
  const auto pieces = pieces_of_segment(meshes.visibility, 0);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_LT(distance_to_segment(pieces[0].to, {10, 10}, {80, 73}), meshes.patch.lattice_step);
  EXPECT_LT(distance_to_segment(pieces[0].to, {15, 70}, {77, 12}), meshes.patch.lattice_step);
}

TEST(Mesher, duplicates_share_one_constraint_in_drawing_order) {
  const Meshes meshes =
      meshes_of(flat_curves({{{20, 30}, {70, 40}}, {{20, 30}, {70, 40}}, {{20, 30}, {70, 40}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 1u);
  const auto c = constraint_between(meshes.visibility, {20, 30}, {70, 40});
  ASSERT_TRUE(c);
  const auto pieces = meshes.visibility.pieces(*c);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].segment, 0u);
  EXPECT_EQ(pieces[1].segment, 2u);
  EXPECT_EQ(pieces[2].segment, 4u);
}

TEST(Mesher, a_reversed_duplicate_runs_against_the_constraint) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {70, 40}}, {{70, 40}, {20, 30}}}));
  const auto c = constraint_between(meshes.visibility, {20, 30}, {70, 40});
  ASSERT_TRUE(c);
  const auto pieces = meshes.visibility.pieces(*c);
  ASSERT_EQ(pieces.size(), 2u);
  const bool along = meshes.visibility.vertex_position[c->from] == Vec2{20, 30};
  EXPECT_EQ(pieces[0].u_from, along ? 0 : 1);
  EXPECT_EQ(pieces[0].u_to, along ? 1 : 0);
  EXPECT_EQ(pieces[1].u_from, along ? 1 : 0);
  EXPECT_EQ(pieces[1].u_to, along ? 0 : 1);
}

TEST(Mesher, a_partial_overlap_has_both_owners_where_both_run) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {60, 30}}, {{40, 30}, {80, 30}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 3u);
  const auto both = constraint_between(meshes.visibility, {40, 30}, {60, 30});
  ASSERT_TRUE(both);
  const auto pieces = meshes.visibility.pieces(*both);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(std::min(pieces[0].u_from, pieces[0].u_to), 0.5f);
  EXPECT_EQ(std::max(pieces[0].u_from, pieces[0].u_to), 1.0f);
  EXPECT_EQ(std::min(pieces[1].u_from, pieces[1].u_to), 0.0f);
  EXPECT_EQ(std::max(pieces[1].u_from, pieces[1].u_to), 0.5f);
}

TEST(Mesher, a_curve_folded_back_on_itself_owns_the_edge_twice) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {60, 30}, {20, 30}}}));
  const auto c = constraint_between(meshes.visibility, {20, 30}, {60, 30});
  ASSERT_TRUE(c);
  const auto pieces = meshes.visibility.pieces(*c);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].segment, 0u);
  EXPECT_EQ(pieces[1].segment, 1u);
  EXPECT_NE(pieces[0].u_from, pieces[1].u_from);
}

TEST(Mesher, a_copy_within_the_weld_falls_onto_the_first) {
  const Meshes meshes =
      meshes_of(flat_curves({{{20, 30}, {70, 40}}, {{20.02, 30.01}, {69.99, 40.02}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 1u);
  EXPECT_EQ(meshes.visibility.piece.size(), 2u);
}

TEST(Mesher, a_vertex_within_the_weld_of_a_segment_leads_it_through) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {80, 30}}, {{50, 30.03125}, {50, 60}}}));
  const auto pieces = pieces_of_segment(meshes.visibility, 0);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].to, (Vec2{50, 30.03125}));
  EXPECT_EQ(pieces[0].u_to, 0.5f);
}

TEST(Mesher, a_t_junction_cuts_the_bar) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}, {80, 30}}, {{35, 30}, {35, 60}}}));
  const auto bar = pieces_of_segment(meshes.visibility, 0);
  ASSERT_EQ(bar.size(), 2u);
  EXPECT_EQ(bar[0].u_to, 0.25f);
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 2).size(), 1u);
}

TEST(Mesher, segments_of_length_zero_vanish) {
  const Meshes meshes =
      meshes_of(flat_curves({{{20, 30}, {20, 30}, {20.01, 30}}, {{50, 50}, {60, 50}, {60, 50}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 1u);
  ASSERT_EQ(meshes.visibility.piece.size(), 1u);
  EXPECT_EQ(meshes.visibility.piece[0].segment, 3u);
}

TEST(Mesher, a_curve_of_one_vertex_has_no_segment) {
  const Meshes meshes = meshes_of(flat_curves({{{20, 30}}, {{50, 50}, {60, 50}}}));
  ASSERT_EQ(meshes.visibility.piece.size(), 1u);
  EXPECT_EQ(meshes.visibility.piece[0].segment, 1u);
}

TEST(Mesher, collinear_segments_in_any_order_share_their_vertices) {
  const Meshes meshes = meshes_of(flat_curves(
      {{{10, 10}, {90, 90}}, {{30, 30}, {50, 50}}, {{70, 70}, {20, 20}}, {{10, 10}, {90, 90}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 5u);
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 0).size(), 5u);
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 2).size(), 1u);
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 4).size(), 3u);
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 6).size(), 5u);
}

TEST(Mesher, a_segment_on_the_frame_owns_its_stretch) {
  const Meshes meshes = meshes_of(flat_curves({{{25, 0}, {75, 0}}}));
  const auto c = constraint_between(meshes.visibility, {25, 0}, {75, 0});
  ASSERT_TRUE(c);
  EXPECT_EQ(meshes.visibility.pieces(*c).size(), 1u);
  const auto frame_only = constraint_between(meshes.visibility, {0, 0}, {25, 0});
  ASSERT_TRUE(frame_only);
  EXPECT_TRUE(meshes.visibility.pieces(*frame_only).empty());
}

TEST(Mesher, a_segment_across_the_frame_is_whole_in_one_mesh_and_cut_in_the_other) {
  const Meshes meshes = meshes_of(flat_curves({{{50, 50}, {150, 50}}}));
  EXPECT_EQ(pieces_of_segment(meshes.visibility, 0).size(), 2u);
  const auto inside = pieces_of_segment(meshes.patch, 0);
  ASSERT_FALSE(inside.empty());
  EXPECT_EQ(inside.front().u_from, 0);
  EXPECT_EQ(inside.back().u_to, 0.5f);
}

TEST(Mesher, curves_outside_the_frame_stand_in_the_visibility_mesh_only) {
  const Meshes meshes = meshes_of(flat_curves({{{150, 20}, {150, 80}}, {{-40, 5}, {-30, 95}}}));
  EXPECT_EQ(curve_constraint_count(meshes.visibility), 2u);
  EXPECT_EQ(curve_constraint_count(meshes.patch), 0u);
}

TEST(Mesher, positions_are_whole_multiples_of_a_power_of_two) {
  const Meshes meshes = meshes_of(flat_curves({{{20.3, 30.7}, {70.1, 40.9}}}));
  EXPECT_EQ(meshes.visibility.lattice_step, 0x1p-12);
  for (const Vec2 p : meshes.patch.vertex_position) {
    EXPECT_EQ(p.x * 4096, std::floor(p.x * 4096));
    EXPECT_EQ(p.y * 4096, std::floor(p.y * 4096));
  }
}

}  // namespace
}  // namespace sfumato::mesh::test
