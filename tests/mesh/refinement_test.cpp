#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mesh/flat_input.hpp"
#include "mesh/fuzz_kinds.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

class Refinement : public ::testing::Test {
 protected:
  Mesher refined(const curves::FlatCurves& flat, const MeshOptions& options) {
    Result<Mesher> mesher = Mesher::build(context_, flat, options);
    EXPECT_TRUE(mesher.ok()) << mesher.status().message;
    EXPECT_TRUE(mesher->refine(context_).ok());
    return std::move(*mesher);
  }

  Context context_;
};

double smallest_angle_of_all(const TriangleMesh& mesh) {
  double least = 180;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    least = std::min(least, smallest_angle(mesh, t));
  }
  return least;
}

curves::FlatCurves crossing_lines() {
  return flat_curves({{{11, 13}, {83, 77}}, {{20, 80}, {70, 9}}, {{5, 50}, {95, 52}}});
}

TEST_F(Refinement, the_minimum_angle_holds_where_the_input_has_no_smaller) {
  for (double angle : {10.0, 22.0, 28.0}) {
    MeshOptions options = options_100();
    options.min_angle_deg = angle;
    const curves::FlatCurves flat = flat_curves({{{11, 13}, {83, 77}}, {{20, 80}, {70, 9}}});
    const TriangleMesh patch = *refined(flat, options).patch_mesh({});
    EXPECT_GE(smallest_angle_of_all(patch), angle - 0.01);
  }
}

TEST_F(Refinement, no_minimum_angle_leaves_the_arrangement) {
  MeshOptions options = options_100();
  options.min_angle_deg = 0;
  Result<Mesher> mesher = Mesher::build(context_, flat_curves({{{11, 13}, {83, 77}}}), options);
  ASSERT_TRUE(mesher.ok());
  const std::uint32_t before = mesher->patch_mesh({})->triangle_count();
  ASSERT_TRUE(mesher->refine(context_).ok());
  EXPECT_EQ(mesher->patch_mesh({})->triangle_count(), before);
}

TEST_F(Refinement, the_largest_area_holds) {
  MeshOptions options = options_100();
  options.max_area = 7;
  const TriangleMesh patch = *refined(crossing_lines(), options).patch_mesh({});
  for (std::uint32_t t = 0; t < patch.triangle_count(); ++t) EXPECT_LE(area(patch, t), 7);
}

TEST_F(Refinement, triangles_outside_the_frame_are_left_alone) {
  MeshOptions options = options_100();
  options.max_area = 50;
  curves::FlatCurves flat = crossing_lines();
  add_polyline(flat, {{300, 0}, {300.5, 80}, {301, 0}});
  Mesher mesher = refined(flat, options);
  const TriangleMesh whole = *mesher.visibility_mesh({});
  const auto count_outside = [](const TriangleMesh& mesh) {
    std::size_t count = 0;
    for (const Vec2 p : mesh.vertex_position) count += p.x > 110;
    return count;
  };
  Result<Mesher> unrefined = Mesher::build(context_, flat, options);
  ASSERT_TRUE(unrefined.ok());
  EXPECT_EQ(count_outside(whole), count_outside(*unrefined->visibility_mesh({})));
}

TEST_F(Refinement, a_needle_of_two_curves_ends) {
  // 0.6 degrees: no mesher can do better there, and a poor one never stops.
  const TriangleMesh patch =
      *refined(flat_curves({{{10, 50}, {90, 50}}, {{10, 50}, {90, 50.8}}}), options_100())
           .patch_mesh({});
  EXPECT_TRUE(is_valid(patch).ok());
  EXPECT_LT(patch.triangle_count(), 2000u);
}

TEST_F(Refinement, parallel_curves_just_beyond_the_weld_end) {
  const TriangleMesh patch =
      *refined(flat_curves({{{10, 50}, {90, 50}}, {{10, 50.07}, {90, 50.07}}}), options_100())
           .patch_mesh({});
  EXPECT_TRUE(is_valid(patch).ok());
  EXPECT_LT(patch.triangle_count(), 20'000u);
}

TEST_F(Refinement, an_angle_beyond_what_refinement_guarantees_does_not_run_away) {
  MeshOptions options;
  options.frame = {{-500, -500}, {2000, 1500}};
  options.weld_px = 1.0 / 64;
  options.min_angle_deg = 30;
  const TriangleMesh patch = *refined(fuzz_scene(FuzzKind::tangents, 1028), options).patch_mesh({});
  EXPECT_TRUE(is_valid(patch).ok());
  EXPECT_LT(patch.triangle_count(), 400'000u);
}

/// Returns lines of 80 units, spread over 4 units.
curves::FlatCurves parallels(int count) {
  curves::FlatCurves flat;
  for (int i = 0; i < count; ++i) {
    const double y = 50 + 4.0 * i / count;
    add_polyline(flat, {{10, y}, {90, y}});
  }
  return flat;
}

TEST_F(Refinement, triangles_between_close_parallels_are_as_many_as_small_edges_fit_along_them) {
  const auto count_triangles = [&](int lines, double small_edge) {
    MeshOptions options = options_100();
    options.small_edge = small_edge;
    const TriangleMesh patch = *refined(parallels(lines), options).patch_mesh({});
    EXPECT_TRUE(is_valid(patch).ok());
    return static_cast<double>(patch.triangle_count());
  };
  EXPECT_LT(count_triangles(40, 1), 2.2 * count_triangles(20, 1));
  EXPECT_GT(count_triangles(40, 0), 3 * count_triangles(20, 0));
}

TEST_F(Refinement, triangles_larger_than_the_small_edge_keep_the_minimum_angle) {
  MeshOptions options = options_100();
  options.small_edge = 2;
  curves::FlatCurves flat = parallels(40);
  add_polyline(flat, {{20, 20}, {40, 35}, {80, 30}});
  const TriangleMesh patch = *refined(flat, options).patch_mesh({});
  for (std::uint32_t t = 0; t < patch.triangle_count(); ++t) {
    const double top = patch.vertex_position[patch.triangle_vertex[3 * t]].y;
    const bool is_between = top > 47 && top < 57;
    if (longest_edge(patch, t) > 2 && !is_between) {
      EXPECT_GE(smallest_angle(patch, t), 21.9) << t;
    }
  }
}

TEST_F(Refinement, nothing_changes_between_two_extractions) {
  Mesher mesher = refined(crossing_lines(), options_100());
  const TriangleMesh first = *mesher.patch_mesh({});
  EXPECT_EQ(mesh_hash(first), mesh_hash(*mesher.patch_mesh({})));
}

TEST_F(Refinement, triangles_below_the_smallest_edge_are_left_alone) {
  Mesher mesher = refined(crossing_lines(), options_100());
  const TriangleMesh before = *mesher.patch_mesh({});
  std::vector<std::uint32_t> all(before.triangle_count());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  ASSERT_TRUE(mesher.refine_triangles(context_, all, 1000).ok());
  EXPECT_EQ(mesh_hash(*mesher.patch_mesh({})), mesh_hash(before));
}

TEST_F(Refinement, every_triangle_reaches_the_smallest_edge_in_the_end) {
  Mesher mesher = refined(crossing_lines(), options_100());
  std::uint32_t rounds = 0;
  for (;; ++rounds) {
    const TriangleMesh patch = *mesher.patch_mesh({});
    ASSERT_TRUE(is_valid(patch).ok());
    std::vector<std::uint32_t> large;
    for (std::uint32_t t = 0; t < patch.triangle_count(); ++t) {
      if (longest_edge(patch, t) > 2.5) large.push_back(t);
    }
    if (large.empty()) break;
    ASSERT_LT(rounds, 30u);
    ASSERT_TRUE(mesher.refine_triangles(context_, large, 2.5).ok());
  }
  EXPECT_GT(rounds, 3u);
  // Two of the lines meet at 40 degrees.
  EXPECT_GE(smallest_angle_of_all(*mesher.patch_mesh({})), 20);
}

TEST_F(Refinement, indices_beyond_the_mesh_are_ignored) {
  Mesher mesher = refined(crossing_lines(), options_100());
  const TriangleMesh before = *mesher.patch_mesh({});
  const std::vector<std::uint32_t> beyond{before.triangle_count(), 0xffffffffu};
  ASSERT_TRUE(mesher.refine_triangles(context_, beyond, 0.1).ok());
  EXPECT_EQ(mesh_hash(*mesher.patch_mesh({})), mesh_hash(before));
}

TEST_F(Refinement, the_same_input_gives_the_same_mesh) {
  MeshOptions options;
  options.frame = {{0, 0}, {kFuzzSide, kFuzzSide}};
  const curves::FlatCurves flat = fuzz_scene(FuzzKind::crossings, 7);
  EXPECT_EQ(mesh_hash(*refined(flat, options).patch_mesh({})),
            mesh_hash(*refined(flat, options).patch_mesh({})));
}

}  // namespace
}  // namespace sfumato::mesh::test
