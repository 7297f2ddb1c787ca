#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "base/charge.hpp"
#include "mesh/arrangement_check.hpp"
#include "mesh/flat_input.hpp"
#include "mesh/fuzz_kinds.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"
#include "support/cancel_at.hpp"
#include "support/same_mesh.hpp"
#include "support/sanitizers.hpp"

/// Curves that are removed from a mesh and inserted, on the same lattice.
namespace sfumato::mesh::test {
namespace {

using sfumato::test::CancelAt;

constexpr int kEditSeeds = SFUMATO_HAS_SANITIZER ? 1 : 5;

double weld_of(const MeshOptions& options) {
  return options.unit_size * options.weld_px;
}

/// Appends curve c of `from`, moved, to `to`.
void append_curve(const curves::FlatCurves& from, std::uint32_t c, Vec2 by,
                  curves::FlatCurves& to) {
  std::vector<Vec2> polyline(from.vertex.begin() + from.curve_begin[c],
                             from.vertex.begin() + from.curve_begin[c + 1]);
  for (Vec2& p : polyline) p = p + by;
  add_polyline(to, polyline);
}

/// A drawing that is edited, and its present segments.
struct Edited {
  curves::FlatCurves flat;
  std::vector<std::uint8_t> is_gone;  ///< per vertex

  std::vector<std::uint8_t> removal(std::uint32_t curve) {
    std::vector<std::uint8_t> is_removed(flat.vertex.size(), 0);
    for (std::uint32_t v = flat.curve_begin[curve]; v < flat.curve_begin[curve + 1]; ++v) {
      is_removed[v] = is_gone[v] = 1;
    }
    return is_removed;
  }

  /// Returns the present curves, without the indices of the others.
  curves::FlatCurves present() const {
    curves::FlatCurves result;
    result.curve_begin.push_back(0);
    for (std::uint32_t c = 0; c < flat.curve_count(); ++c) {
      if (!is_gone[flat.curve_begin[c]]) append_curve(flat, c, {}, result);
    }
    return result;
  }
};

/// Expects pieces on the mesh only for present segments, and renumbers them as in present().
void renumber(const Edited& edited, TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(edited.flat.vertex.size(), 0);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    number[v] = count;
    if (!edited.is_gone[v]) ++count;
  }
  for (SegmentPiece& piece : mesh.piece) {
    ASSERT_FALSE(edited.is_gone[piece.segment]) << "a segment that was taken out";
    piece.segment = number[piece.segment];
  }
}

void expect_good(const Edited& edited, Mesher& mesher, double weld) {
  TriangleMesh mesh = *mesher.visibility_mesh({});
  const Status valid = is_valid(mesh);
  ASSERT_TRUE(valid.ok()) << valid.message;
  ASSERT_NO_FATAL_FAILURE(renumber(edited, mesh));
  const ArrangementFacts facts = check_arrangement(mesh, edited.present(), weld);
  ASSERT_EQ(facts.broken, "");
  ASSERT_LE(facts.input_to_mesh, 2.5 * weld);
  ASSERT_LE(facts.mesh_to_input, 2.5 * weld);
}

class MeshEdits : public testing::TestWithParam<int> {
 protected:
  FuzzKind kind() const { return static_cast<FuzzKind>(GetParam()); }
};

/// Removes a curve and inserts it again, moved a little, whatever it is and however often.
void edit_once(std::mt19937& random, Edited& edited, Mesher& mesher, bool refines) {
  const std::uint32_t curve = random() % edited.flat.curve_count();
  const std::vector<std::uint8_t> is_removed = edited.removal(curve);
  const auto first = static_cast<std::uint32_t>(edited.flat.vertex.size());
  const Vec2 by{double(random() % 9) - 4, double(random() % 9) - 4};
  curves::FlatCurves moved = edited.flat;
  append_curve(edited.flat, curve, by, moved);
  if (mesher.holds(moved, first)) edited.flat = moved;
  edited.is_gone.resize(edited.flat.vertex.size(), 0);
  const Status status = mesher.edit({}, edited.flat, {is_removed, first}, refines);
  ASSERT_TRUE(status.ok()) << status.message;
}

/// Calls `body` with built scenes of the kind and a source of random numbers.
template <class Body>
void for_each_scene(FuzzKind kind, Body body) {
  for (std::uint64_t seed = 0; seed < kEditSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Context context;
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    Edited edited{fuzz_scene(kind, seed), {}};
    edited.is_gone.resize(edited.flat.vertex.size(), 0);
    if (edited.flat.curve_begin.empty() || edited.flat.curve_count() == 0) continue;
    Result<Mesher> mesher = Mesher::build(context, edited.flat, fuzz_options());
    ASSERT_TRUE(mesher.ok());
    ASSERT_NO_FATAL_FAILURE(body(context, random, edited, *mesher));
  }
}

TEST_P(MeshEdits, leave_a_valid_arrangement_of_the_curves_that_are_there) {
  for_each_scene(kind(), [](Context&, std::mt19937& random, Edited& edited, Mesher& mesher) {
    for (int step = 0; step < 6; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      ASSERT_NO_FATAL_FAILURE(edit_once(random, edited, mesher, false));
      ASSERT_NO_FATAL_FAILURE(expect_good(edited, mesher, weld_of(fuzz_options())));
    }
  });
}

/// Returns the number of constraints that lie on no edge and yet have pieces.
std::size_t dead_constraints(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> lives(mesh.constraint.size(), 0);
  for (const std::int32_t c : mesh.half_edge_constraint)
    if (c != kNone) lives[static_cast<std::size_t>(c)] = 1;
  std::size_t dead = 0;
  for (std::size_t c = 0; c < lives.size(); ++c)
    dead += !lives[c] && !mesh.pieces(mesh.constraint[c]).empty();
  return dead;
}

TEST_P(MeshEdits, leave_a_valid_patch_mesh) {
  for_each_scene(kind(),
                 [](Context& context, std::mt19937& random, Edited& edited, Mesher& mesher) {
                   ASSERT_TRUE(mesher.refine(context).ok());
                   TriangleMesh patch = *mesher.patch_mesh({});
                   for (int step = 0; step < 3 && patch.triangle_count() < 100'000; ++step) {
                     SCOPED_TRACE("step " + std::to_string(step));
                     ASSERT_NO_FATAL_FAILURE(edit_once(random, edited, mesher, true));
                     TableMemory memory("a test");
                     std::vector<std::uint32_t> changed;
                     ASSERT_TRUE(mesher.update_patch_mesh(context, patch, memory, changed).ok());
                     const TriangleMesh anew = *mesher.patch_mesh({});
                     const Status valid = is_valid(anew);
                     ASSERT_TRUE(valid.ok()) << valid.message;
                     ASSERT_EQ(sfumato::test::difference_on_edges(patch, anew), "");
                     ASSERT_EQ(dead_constraints(patch), 0u);
                     ASSERT_NO_FATAL_FAILURE(expect_good(edited, mesher, weld_of(fuzz_options())));
                   }
                 });
}

/// Expects the former mesh after the change is taken back.
void expect_taken_back(const TriangleMesh& before, const std::vector<std::uint32_t>& changed,
                       TriangleMesh mesh) {
  if (changed.size() == mesh.triangle_count()) return;  // it was built again
  Mesher::take_back(before, changed, mesh);
  EXPECT_EQ(sfumato::test::difference_of(mesh, before), "");
}

/// Inserts a curve into a copy: its patch mesh is updated, and must equal a newly extracted one.
/// Returns whether only the changes were updated. Does the same with a used copy.
bool insert_into_copy(std::mt19937& random, const curves::FlatCurves& flat, const Mesher& mesher,
                      const TriangleMesh& patch, Mesher& used) {
  Context context;
  curves::FlatCurves more = flat;
  const auto first = static_cast<std::uint32_t>(flat.vertex.size());
  const Vec2 by{double(random() % 9) - 4, double(random() % 9) - 4};
  append_curve(flat, static_cast<std::uint32_t>(random() % flat.curve_count()), by, more);
  Result<Mesher> copy = mesher.copy(context);
  EXPECT_TRUE(copy.ok());
  if (!copy->holds(more, first)) return false;
  Result<Mesher> fresh = mesher.copy(context);
  EXPECT_TRUE(fresh.ok() && used.copy_from(context, mesher).ok());
  for (Mesher* edited : {&*copy, &*fresh, &used})
    EXPECT_TRUE(edited->edit(context, more, {{}, first}, true).ok());
  EXPECT_EQ(sfumato::test::difference_of(*used.patch_mesh({}), *fresh->patch_mesh({})), "");
  const bool follows = copy->follows_changes();
  TriangleMesh mesh = *copy->copy_mesh(context, patch);
  TableMemory memory("a test");
  std::vector<std::uint32_t> changed;
  EXPECT_TRUE(copy->update_patch_mesh(context, mesh, memory, changed).ok());
  EXPECT_EQ(sfumato::test::difference_on_edges(mesh, *copy->patch_mesh({})), "");
  EXPECT_EQ(dead_constraints(mesh), 0u);
  expect_taken_back(patch, changed, mesh);
  return follows && changed.size() < mesh.triangle_count();
}

/// The same for the visibility mesh, with a mesher whose memory was used before.
void insert_into_used_copy(std::mt19937& random, const curves::FlatCurves& flat,
                           const Mesher& mesher, const TriangleMesh& visibility, Mesher& copy) {
  Context context;
  curves::FlatCurves more = flat;
  const auto first = static_cast<std::uint32_t>(flat.vertex.size());
  const Vec2 by{double(random() % 9) - 4, double(random() % 9) - 4};
  append_curve(flat, static_cast<std::uint32_t>(random() % flat.curve_count()), by, more);
  ASSERT_TRUE(copy.copy_from(context, mesher).ok());
  if (!copy.holds(more, first)) return;
  Result<Mesher> fresh = mesher.copy(context);
  ASSERT_TRUE(fresh.ok());
  for (Mesher* edited : {&copy, &*fresh})
    ASSERT_TRUE(edited->edit(context, more, {{}, first}, false).ok());
  ASSERT_EQ(sfumato::test::difference_of(*copy.visibility_mesh({}), *fresh->visibility_mesh({})),
            "");
  TableMemory memory("a test");
  const auto is_same = copy.same_triangles(context, mesher, memory);
  ASSERT_TRUE(is_same.ok());
  TriangleMesh mesh = *copy.copy_mesh(context, visibility);
  std::vector<std::uint32_t> changed;
  ASSERT_TRUE(copy.update_visibility_mesh(context, *is_same, mesh, memory, changed).ok());
  EXPECT_EQ(sfumato::test::difference_on_edges(mesh, *copy.visibility_mesh({})), "");
  EXPECT_EQ(dead_constraints(mesh), 0u);
  expect_taken_back(visibility, changed, mesh);
}

TEST_P(MeshEdits, that_insert_are_followed_by_the_visibility_mesh) {
  for_each_scene(kind(),
                 [&](Context& context, std::mt19937& random, Edited& edited, Mesher& mesher) {
                   ASSERT_TRUE(mesher.bake(context).ok());
                   const TriangleMesh visibility = *mesher.visibility_mesh({});
                   Result<Mesher> copy = mesher.copy(context);
                   ASSERT_TRUE(copy.ok());
                   for (int i = 0; i < 4; ++i)
                     ASSERT_NO_FATAL_FAILURE(
                         insert_into_used_copy(random, edited.flat, mesher, visibility, *copy));
                 });
}

TEST_P(MeshEdits, that_insert_are_followed_by_the_patch_mesh) {
  int followed = 0;
  for_each_scene(kind(),
                 [&](Context& context, std::mt19937& random, Edited& edited, Mesher& mesher) {
                   ASSERT_TRUE(mesher.refine(context).ok());
                   ASSERT_TRUE(mesher.bake(context).ok());
                   const TriangleMesh patch = *mesher.patch_mesh({});
                   if (patch.triangle_count() > 100'000) return;
                   Result<Mesher> used = mesher.copy(context);
                   ASSERT_TRUE(used.ok());
                   for (int i = 0; i < 4; ++i)
                     followed += insert_into_copy(random, edited.flat, mesher, patch, *used);
                 });
  RecordProperty("followed", followed);
}

TEST(MeshEdit, of_a_copy_made_before_the_patch_mesh_followed_is_extracted_anew) {
  Context context;
  const curves::FlatCurves flat = flat_curves({{{10, 10}, {90, 80}}, {{20, 90}, {30, 10}}});
  Result<Mesher> mesher = Mesher::build(context, flat, options_100());
  ASSERT_TRUE(mesher->refine(context).ok());
  ASSERT_TRUE(mesher->patch_mesh({}).ok());
  const std::vector<std::uint32_t> all{0, 1, 2, 3};
  ASSERT_TRUE(mesher->refine_triangles(context, all, 0.5).ok());
  Result<Mesher> copy = mesher->copy(context);
  ASSERT_TRUE(copy.ok());
  const TriangleMesh mesh = *copy->patch_mesh({});
  EXPECT_TRUE(is_valid(mesh).ok());
  EXPECT_EQ(mesh.triangle_count(), mesher->patch_mesh({})->triangle_count());
}

TEST(MeshEdit, of_a_copy_is_not_taken_back_where_the_original_has_changed) {
  Context context;
  const curves::FlatCurves flat = flat_curves({{{10, 10}, {90, 80}}, {{20, 90}, {30, 10}}});
  Result<Mesher> mesher = Mesher::build(context, flat, options_100());
  ASSERT_TRUE(mesher->refine(context).ok());
  Result<Mesher> copy = mesher->copy(context);
  ASSERT_TRUE(copy.ok());
  ASSERT_TRUE(mesher->patch_mesh({}).ok());
  const std::vector<std::uint32_t> all{0, 1, 2, 3};
  ASSERT_TRUE(mesher->refine_triangles(context, all, 0.5).ok());
  const TriangleMesh changed = *mesher->patch_mesh({});
  ASSERT_TRUE(copy->copy_from(context, *mesher).ok());
  EXPECT_EQ(sfumato::test::difference_of(*copy->patch_mesh({}), changed), "");
}

/// Two curves: the first was removed, and a third inserted.
struct SmallEdit {
  curves::FlatCurves flat = flat_curves({{{10, 10}, {90, 80}}, {{20, 90}, {30, 10}}});
  std::vector<std::uint8_t> is_removed{1, 1, 0, 0};
  std::uint32_t first = 4;

  SmallEdit() { add_polyline(flat, {{5, 50}, {95, 55}}); }

  Result<Mesher> built(Context& context) const {
    const curves::FlatCurves before = flat_curves({{{10, 10}, {90, 80}}, {{20, 90}, {30, 10}}});
    Result<Mesher> mesher = Mesher::build(context, before, options_100());
    if (!mesher) return mesher;
    Status status = mesher->refine(context);
    if (!status) return status;
    return mesher;
  }
};

TEST(MeshEdit, that_reaches_beyond_the_lattice_is_refused_and_changes_nothing) {
  Context context;
  SmallEdit edit;
  Result<Mesher> mesher = edit.built(context);
  ASSERT_TRUE(mesher.ok());
  const std::uint64_t before = mesh_hash(*mesher->patch_mesh({}));
  for (const double far : {1e4, -1e4, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    curves::FlatCurves flat = edit.flat;
    flat.vertex.back().y = far;
    EXPECT_FALSE(mesher->holds(flat, edit.first));
    EXPECT_EQ(mesher->edit(context, flat, {edit.is_removed, edit.first}, true).code,
              StatusCode::bad_input);
  }
  EXPECT_EQ(mesh_hash(*mesher->patch_mesh({})), before);
}

TEST(MeshEdit, ends_at_any_poll_that_finds_it_cancelled) {
  SmallEdit edit;
  int cancelled = 0;
  for (std::uint64_t poll = 1;; ++poll) {
    Context context;
    Result<Mesher> mesher = edit.built(context);
    ASSERT_TRUE(mesher.ok());
    CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Status status = mesher->edit(context, edit.flat, {edit.is_removed, edit.first}, true);
    if (status.ok()) {
      EXPECT_TRUE(is_valid(*mesher->visibility_mesh({})).ok());
      if (!context.cancelled()) break;
    } else {
      EXPECT_EQ(status.code, StatusCode::cancelled);
      ++cancelled;
    }
  }
  EXPECT_GT(cancelled, 5);
}

TEST(MeshEdit, ends_where_memory_is_short_and_gives_back_what_it_took) {
  SmallEdit edit;
  int failures = 0;
  bool fitted = false;
  for (std::size_t room = 0; !fitted; room += 256) {
    Context context;
    {
      Result<Mesher> mesher = edit.built(context);
      ASSERT_TRUE(mesher.ok());
      ScopedCharge taken;
      ASSERT_TRUE(taken.add(context, context.budget.room() - room, "the test").ok());
      const Status status = mesher->edit(context, edit.flat, {edit.is_removed, edit.first}, true);
      fitted = status.ok();
      if (!fitted) {
        ASSERT_EQ(status.code, StatusCode::limit);
        ++failures;
      }
    }
    EXPECT_EQ(context.budget.used(), 0u);
  }
  EXPECT_GT(failures, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshEdits, testing::Range(0, kFuzzKindCount));

}  // namespace
}  // namespace sfumato::mesh::test
