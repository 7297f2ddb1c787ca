#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/charge.hpp"
#include "mesh/flat_input.hpp"
#include "mesh/fuzz_kinds.hpp"
#include "mesh/is_valid.hpp"
#include "mesh/mesh_facts.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

StatusCode build_code(const curves::FlatCurves& flat, const MeshOptions& options) {
  Context context;
  return Mesher::build(context, flat, options).status().code;
}

void expect_valid(const curves::FlatCurves& flat, const MeshOptions& options) {
  Context context;
  Result<Mesher> mesher = Mesher::build(context, flat, options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  Status valid = is_valid(*mesher->visibility_mesh({}));
  EXPECT_TRUE(valid.ok()) << valid.message;
  ASSERT_TRUE(mesher->refine(context).ok());
  valid = is_valid(*mesher->patch_mesh({}));
  EXPECT_TRUE(valid.ok()) << valid.message;
}

TEST(MesherLimits, coordinates_at_the_limit_coarsen_the_lattice) {
  const double far = limits::kCoordinate;
  expect_valid(flat_curves({{{-far, -far}, {far, far}}, {{-far, far}, {far, -far}}}),
               options_100());
  MeshOptions options = options_100();
  options.frame = {{-far, -far}, {far, far}};
  expect_valid(flat_curves({{{-far, -far}, {far, far}}, {{-far, 0}, {far, 1}}}), options);
}

TEST(MesherLimits, a_tiny_unit_far_from_the_origin_keeps_positions_exact) {
  const double far = limits::kCoordinate;
  MeshOptions options;
  options.frame = {{far - 1e-3, far - 1e-3}, {far, far}};
  options.unit_size = 1e-6;
  expect_valid(flat_curves({{{far - 9e-4, far - 9e-4}, {far - 1e-4, far - 2e-4}}}), options);
}

TEST(MesherLimits, a_frame_smaller_than_the_weld_is_meshed) {
  MeshOptions options;
  options.frame = {{50, 50}, {50.01, 50.02}};
  expect_valid(flat_curves({{{0, 0}, {100, 100.01}}, {{50.005, 50}, {50.005, 60}}}), options);
}

TEST(MesherLimits, a_weld_larger_than_everything_is_reduced) {
  MeshOptions options = options_100();
  options.weld_px = 1e6;
  expect_valid(flat_curves({{{10, 10}, {90, 80}}, {{20, 90}, {30, 10}}}), options);
}

TEST(MesherLimits, a_long_thin_frame_is_meshed) {
  MeshOptions options;
  options.frame = {{0, 0}, {1e4, 1}};
  expect_valid(flat_curves({{{-10, 0.2}, {9'900, 0.7}}}), options);
}

TEST(MesherLimits, an_area_that_asks_for_too_many_triangles_is_refused_before_any_is_made) {
  MeshOptions options = options_100();
  options.max_area = 1e-300;
  Context context;
  Result<Mesher> mesher = Mesher::build(context, flat_curves({{{10, 10}, {90, 80}}}), options);
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  const std::uint32_t before = mesher->visibility_mesh({})->triangle_count();
  const std::size_t charged = context.budget.used();
  EXPECT_EQ(mesher->refine(context).code, StatusCode::limit);
  EXPECT_EQ(mesher->visibility_mesh({})->triangle_count(), before);
  EXPECT_EQ(context.budget.used(), charged);
}

TEST(MesherLimits, many_curves_from_one_point_are_meshed) {
  curves::FlatCurves flat;
  for (int i = 0; i < 3000; ++i) {
    const double angle = i * 2e-3;
    add_polyline(flat, {{50, 50}, {50 + 40 * std::cos(angle), 50 + 40 * std::sin(angle)}});
  }
  expect_valid(flat, options_100());
}

TEST(MesherLimits, a_grid_of_curves_is_meshed) {
  curves::FlatCurves flat;
  for (int i = 1; i < 60; ++i) {
    add_polyline(flat, {{1.6 * i, -5}, {1.6 * i, 105}});
    add_polyline(flat, {{-5, 1.6 * i}, {105, 1.6 * i}});
  }
  expect_valid(flat, options_100());
}

TEST(MesherLimits, bad_frames_units_and_coordinates_are_refused) {
  const curves::FlatCurves flat = flat_curves({{{10, 10}, {90, 80}}});
  MeshOptions options = options_100();
  options.frame = {};
  EXPECT_EQ(build_code(flat, options), StatusCode::bad_input);
  options.frame = {{0, 0}, {100, 0}};
  EXPECT_EQ(build_code(flat, options), StatusCode::bad_input);
  options.frame = {{0, 0}, {1e308, 1e308}};
  EXPECT_EQ(build_code(flat, options), StatusCode::bad_input);
  for (double unit : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::infinity()}) {
    options = options_100();
    options.unit_size = unit;
    EXPECT_EQ(build_code(flat, options), StatusCode::bad_input);
  }
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    EXPECT_EQ(build_code(flat_curves({{{10, 10}, {bad, 80}}}), options_100()),
              StatusCode::bad_input);
  }
}

TEST(MesherLimits, too_many_segments_are_refused) {
  curves::FlatCurves flat;
  flat.vertex.resize(limits::kSegments + 2);
  flat.curve_begin = {0, static_cast<std::uint32_t>(limits::kSegments + 2)};
  EXPECT_EQ(build_code(flat, options_100()), StatusCode::limit);
}

TEST(MesherLimits, a_small_memory_budget_is_kept) {
  Context context{.budget = Budget(100'000)};
  const Result<Mesher> mesher =
      Mesher::build(context, fuzz_scene(FuzzKind::crossings, 1), options_100());
  EXPECT_EQ(mesher.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(MesherLimits, an_area_that_asks_for_more_than_the_budget_is_refused) {
  MeshOptions options = options_100();
  options.max_area = 1e-4;
  Context context{.budget = Budget(20'000'000)};
  Result<Mesher> mesher = Mesher::build(context, flat_curves({{{10, 10}, {90, 80}}}), options);
  ASSERT_TRUE(mesher.ok());
  EXPECT_EQ(mesher->refine(context).code, StatusCode::limit);
}

/// Refines with `room` bytes left in the budget.
Status refine_with_room(Context& context, Mesher& mesher, std::size_t room) {
  ScopedCharge held;
  const std::size_t taken = context.budget.room() - room;
  Status status = held.add(context, taken, "what others hold");
  return status ? mesher.refine(context) : status;
}

TEST(MesherLimits, after_a_refinement_without_memory_the_mesh_is_valid_and_goes_on) {
  std::size_t failures = 0;
  for (std::size_t room = 1000; failures < 40; room += 1 + room / 6) {
    Context context;
    Result<Mesher> mesher =
        Mesher::build(context, fuzz_scene(FuzzKind::crossings, 2), options_100());
    ASSERT_TRUE(mesher.ok()) << mesher.status().message;
    const Status status = refine_with_room(context, *mesher, room);
    if (status) break;
    ++failures;
    ASSERT_EQ(status.limit, "memory") << room;
    Status valid = is_valid(*mesher->visibility_mesh({}));
    ASSERT_TRUE(valid.ok()) << valid.message << ", room " << room;
    std::vector<std::uint32_t> all(mesher->patch_mesh({})->triangle_count());
    std::iota(all.begin(), all.end(), 0u);
    ASSERT_TRUE(mesher->refine_triangles(context, all, 1).ok()) << room;
    ASSERT_TRUE(mesher->refine(context).ok()) << room;
    valid = is_valid(*mesher->patch_mesh({}));
    ASSERT_TRUE(valid.ok()) << valid.message << ", room " << room;
  }
  EXPECT_GT(failures, 10u);
}

TEST(MesherLimits, pieces_of_overlapping_curves_are_charged) {
  // Curve i lies on all curves after it: about n² / 2 pieces.
  curves::FlatCurves flat;
  for (int i = 0; i < 400; ++i) add_polyline(flat, {{0.125 * i, 50}, {99 - 0.0625 * i, 50}});
  Context context;
  Result<Mesher> mesher = Mesher::build(context, flat, options_100());
  ASSERT_TRUE(mesher.ok()) << mesher.status().message;
  const TriangleMesh mesh = *mesher->visibility_mesh({});
  EXPECT_TRUE(is_valid(mesh).ok());
  EXPECT_GT(mesh.piece.size(), 100'000u);
  EXPECT_GT(context.budget.used(), mesh.piece.size() * sizeof(SegmentPiece));
}

TEST(MesherLimits, memory_is_given_back) {
  Context context;
  {
    Result<Mesher> mesher =
        Mesher::build(context, fuzz_scene(FuzzKind::crossings, 1), options_100());
    ASSERT_TRUE(mesher.ok());
    EXPECT_GT(context.budget.used(), 0u);
    Mesher moved = std::move(*mesher);
    EXPECT_TRUE(moved.refine(context).ok());
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(MesherLimits, a_cancelled_build_says_so) {
  Context context;
  context.cancel = true;
  const Result<Mesher> mesher =
      Mesher::build(context, fuzz_scene(FuzzKind::crossings, 1), options_100());
  EXPECT_EQ(mesher.status().code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::mesh::test
