#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/arrangement_check.hpp"
#include "mesh/fuzz_kinds.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"
#include "support/sanitizers.hpp"
#include "support/soak.hpp"

namespace sfumato::mesh::test {
namespace {

const auto kFuzzSeeds =
    sfumato::test::random_case_count<std::uint64_t>(SFUMATO_HAS_SANITIZER ? 8 : 16, 40);

class MesherFuzz : public testing::TestWithParam<int> {
 protected:
  FuzzKind kind() const { return static_cast<FuzzKind>(GetParam()); }
};

TEST_P(MesherFuzz, every_step_leaves_a_valid_mesh) {
  for (std::uint64_t seed = 0; seed < kFuzzSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    Result<Mesher> mesher = Mesher::build(context, fuzz_scene(kind(), seed), fuzz_options());
    ASSERT_TRUE(mesher.ok()) << mesher.status().message;
    Status valid = is_valid(*mesher->visibility_mesh({}));
    ASSERT_TRUE(valid.ok()) << valid.message;
    ASSERT_TRUE(mesher->refine(context).ok());
    TriangleMesh patch = *mesher->patch_mesh({});
    valid = is_valid(patch);
    ASSERT_TRUE(valid.ok()) << valid.message;
    ASSERT_LT(patch.triangle_count(), 400'000u);
    if (seed % 4 != 0) continue;
    for (int round = 0; round < 2; ++round) {
      std::vector<std::uint32_t> every_third;
      for (std::uint32_t t = 0; t < patch.triangle_count(); t += 3) every_third.push_back(t);
      ASSERT_TRUE(mesher->refine_triangles(context, every_third, 2.0).ok());
      patch = *mesher->patch_mesh({});
      valid = is_valid(patch);
      ASSERT_TRUE(valid.ok()) << valid.message;
    }
  }
}

/// The place of a constraint, and its first piece from the lower end.
using ConstraintPlace = std::array<double, 6>;

std::vector<ConstraintPlace> places_of(const TriangleMesh& mesh, auto is_wanted) {
  std::vector<ConstraintPlace> places;
  for (std::uint32_t c = 0; c < mesh.constraint.size(); ++c) {
    if (!is_wanted(c)) continue;
    const Constraint& constraint = mesh.constraint[c];
    Vec2 a = mesh.vertex_position[constraint.from], b = mesh.vertex_position[constraint.to];
    SegmentPiece piece = mesh.pieces(constraint).front();
    if (std::pair(a.x, a.y) > std::pair(b.x, b.y)) {
      std::swap(a, b);
      std::swap(piece.u_from, piece.u_to);
    }
    places.push_back({a.x, a.y, b.x, b.y, piece.u_from, piece.u_to});
  }
  std::sort(places.begin(), places.end());
  return places;
}

TEST_P(MesherFuzz, a_thinned_mesh_is_valid_and_keeps_what_it_should) {
  for (std::uint64_t seed = 0; seed < kFuzzSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    Result<Mesher> mesher = Mesher::build(context, fuzz_scene(kind(), seed), fuzz_options());
    ASSERT_TRUE(mesher.ok()) << mesher.status().message;
    const TriangleMesh whole = *mesher->visibility_mesh({});
    std::vector<std::uint8_t> keep(whole.constraint.size());
    for (std::uint32_t c = 0; c < keep.size(); ++c) {
      keep[c] = c % 3 != 0 && !whole.pieces(whole.constraint[c]).empty();
    }
    TableMemory memory("a test");
    const Result<TriangleMesh> thinned = mesher->thinned_mesh(context, whole, keep, memory);
    ASSERT_TRUE(thinned.ok()) << thinned.status().message;
    const Status valid = is_valid(*thinned);
    ASSERT_TRUE(valid.ok()) << valid.message;
    EXPECT_EQ(places_of(*thinned, [](std::uint32_t) { return true; }),
              places_of(whole, [&](std::uint32_t c) { return keep[c] != 0; }));
  }
}

TEST_P(MesherFuzz, constraints_stay_near_their_segments_and_cover_them) {
  const MeshOptions options = fuzz_options();
  const double weld = options.weld_px * options.unit_size;
  for (std::uint64_t seed = 0; seed < kFuzzSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    const curves::FlatCurves flat = fuzz_scene(kind(), seed);
    Result<Mesher> mesher = Mesher::build(context, flat, options);
    ASSERT_TRUE(mesher.ok()) << mesher.status().message;
    const ArrangementFacts facts = check_arrangement(*mesher->visibility_mesh({}), flat, weld);
    EXPECT_EQ(facts.broken, "");
    EXPECT_LE(facts.input_to_mesh, 2.5 * weld);
    EXPECT_LE(facts.mesh_to_input, 2.5 * weld);
    // A crossing whose weld would lead a curve astray may be closer to its neighbours.
    EXPECT_GE(facts.vertex_gap, 0.5 * weld);
  }
}

TEST_P(MesherFuzz, a_patch_mesh_fills_the_frame) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    Result<Mesher> mesher = Mesher::build(context, fuzz_scene(kind(), seed), fuzz_options());
    ASSERT_TRUE(mesher.ok()) << mesher.status().message;
    ASSERT_TRUE(mesher->refine(context).ok());
    // The frame may be led through vertices within the weld distance of it.
    EXPECT_NEAR(total_area(*mesher->patch_mesh({})), kFuzzSide * kFuzzSide, 4 * kFuzzSide * 0.15);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, MesherFuzz, testing::Range(0, kFuzzKindCount));

}  // namespace
}  // namespace sfumato::mesh::test
