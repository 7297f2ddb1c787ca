#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "mesh/flat_input.hpp"
#include "mesh/fuzz_kinds.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesher.hpp"
#include "support/cancel_at.hpp"
#include "support/same_mesh.hpp"

/// A patch mesh that is updated with its refinement equals a newly extracted one.
namespace sfumato::mesh::test {
namespace {

using sfumato::test::CancelAt;
using sfumato::test::difference_of;

Mesher refined(Context& context, const curves::FlatCurves& flat, const MeshOptions& options) {
  Result<Mesher> mesher = Mesher::build(context, flat, options);
  EXPECT_TRUE(mesher.ok()) << mesher.status().message;
  EXPECT_TRUE(mesher->refine(context).ok());
  return std::move(*mesher);
}

std::vector<std::uint32_t> some_triangles(const TriangleMesh& mesh, std::mt19937& random) {
  const std::uint32_t share = 2 + random() % 40;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    if (random() % share == 0) triangles.push_back(t);
  }
  return triangles;
}

class MeshUpdates : public testing::TestWithParam<int> {};

TEST_P(MeshUpdates, after_every_round_it_is_the_mesh_that_is_extracted_anew) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    Mesher mesher =
        refined(context, fuzz_scene(static_cast<FuzzKind>(GetParam()), seed), fuzz_options());
    TriangleMesh mesh = *mesher.patch_mesh({});
    TableMemory memory("a test");
    std::vector<std::uint32_t> changed;
    for (int round = 0; round < 6 && mesh.triangle_count() < 60'000; ++round) {
      ASSERT_TRUE(mesher.refine_triangles(context, some_triangles(mesh, random), 1).ok());
      const TriangleMesh before = mesh;
      ASSERT_TRUE(mesher.update_patch_mesh(context, mesh, memory, changed).ok());
      ASSERT_EQ(difference_of(mesh, *mesher.patch_mesh({})), "") << "round " << round;
      ASSERT_TRUE(std::ranges::is_sorted(changed));
      // Triangles that are not listed have not changed.
      std::vector<std::uint8_t> is_changed(mesh.triangle_count(), 0);
      for (const std::uint32_t t : changed) is_changed[t] = 1;
      for (std::uint32_t h = 0; h < mesh.triangle_vertex.size(); ++h) {
        if (is_changed[h / 3]) continue;
        ASSERT_LT(h, before.triangle_vertex.size());
        ASSERT_EQ(mesh.triangle_vertex[h], before.triangle_vertex[h]);
        ASSERT_EQ(mesh.half_edge_constraint[h], before.half_edge_constraint[h]);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshUpdates, testing::Range(0, kFuzzKindCount));

TEST(MeshUpdate, listed_triangles_change_and_most_others_stay) {
  Context context;
  MeshOptions options = options_100();
  options.max_area = 40;
  Mesher mesher =
      refined(context, flat_curves({{{11, 13}, {83, 77}}, {{20, 80}, {70, 9}}}), options);
  TriangleMesh mesh = *mesher.patch_mesh({});
  std::vector<std::uint32_t> near_corner;
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const Vec2 p = mesh.vertex_position[mesh.origin(3 * t)];
    if (p.x < 25 && p.y < 25) near_corner.push_back(t);
  }
  ASSERT_GT(near_corner.size(), 5u);
  ASSERT_TRUE(mesher.refine_triangles(context, near_corner, 0.5).ok());
  const std::vector<Vec2> vertices = mesh.vertex_position;
  TableMemory memory("a test");
  std::vector<std::uint32_t> changed;
  ASSERT_TRUE(mesher.update_patch_mesh(context, mesh, memory, changed).ok());
  EXPECT_TRUE(is_valid(mesh).ok());
  EXPECT_TRUE(std::ranges::includes(changed, near_corner));
  EXPECT_LT(changed.size(), mesh.triangle_count() / 2);
  for (std::size_t v = 0; v < vertices.size(); ++v) EXPECT_EQ(mesh.vertex_position[v], vertices[v]);
}

TEST(MeshUpdate, nothing_changes_where_nothing_was_refined) {
  Context context;
  Mesher mesher = refined(context, fuzz_scene(FuzzKind::crossings, 3), fuzz_options());
  TriangleMesh mesh = *mesher.patch_mesh({});
  const TriangleMesh before = mesh;
  TableMemory memory("a test");
  std::vector<std::uint32_t> changed{1, 2, 3};
  ASSERT_TRUE(mesher.update_patch_mesh(context, mesh, memory, changed).ok());
  EXPECT_TRUE(changed.empty());
  EXPECT_EQ(difference_of(mesh, before), "");
}

TEST(MeshUpdate, whichever_look_sees_the_flag_the_answer_is_cancelled) {
  bool is_done = false;
  std::uint64_t polls = 0;
  for (std::uint64_t k = 1; !is_done; k += 1 + k / 2) {
    Context context;
    Mesher mesher = refined(context, fuzz_scene(FuzzKind::near_copies, 5), fuzz_options());
    TriangleMesh mesh = *mesher.patch_mesh({});
    std::mt19937 random(1);
    ASSERT_TRUE(mesher.refine_triangles(context, some_triangles(mesh, random), 1).ok());
    Context cancelled;
    CancelAt watch(k, cancelled.cancel);
    cancelled.poll_watch = &watch;
    TableMemory memory("a test");
    std::vector<std::uint32_t> changed;
    const Status status = mesher.update_patch_mesh(cancelled, mesh, memory, changed);
    is_done = !cancelled.cancel;
    EXPECT_EQ(status.code, is_done ? StatusCode::ok : StatusCode::cancelled) << k;
    polls = k;
  }
  EXPECT_GT(polls, 50u);
}

/// The flag is set before the start, or at any poll.
TEST(MeshUpdate, a_mesh_may_be_cancelled_while_it_is_made) {
  bool is_done = false;
  for (std::uint64_t k = 0; !is_done; k += 1 + k) {
    Context context, cancelled;
    Mesher mesher = refined(context, fuzz_scene(FuzzKind::near_copies, 5), fuzz_options());
    CancelAt watch(k, cancelled.cancel);
    cancelled.poll_watch = &watch;
    cancelled.cancel = k == 0;
    const Result<TriangleMesh> mesh = mesher.patch_mesh(cancelled);
    is_done = !cancelled.cancel;
    EXPECT_EQ(mesh.status().code, is_done ? StatusCode::ok : StatusCode::cancelled) << k;
  }
}

}  // namespace
}  // namespace sfumato::mesh::test
