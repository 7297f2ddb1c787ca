#include "solve/fields/border.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>

#include "curves/flatten.hpp"
#include "mesh/mesher.hpp"
#include "picture/patch.hpp"
#include "support/drawing.hpp"

namespace sfumato::solve {
namespace {

using Predicate = std::function<bool(Vec2)>;

mesh::TriangleMesh grid_mesh() {
  Context context;
  const std::vector<Curve> curves{test::straight_curve({30, 20}, {60, 45})};
  const Result<curves::FlatCurves> flat = curves::flatten(context, curves, {});
  mesh::MeshOptions options;
  options.frame = {{0, 0}, {100, 100}};
  options.max_area = 30;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  EXPECT_TRUE(mesher.ok());
  EXPECT_TRUE(mesher->refine(context).ok());
  return *mesher->patch_mesh({});
}

Vec2 corner(const mesh::TriangleMesh& mesh, std::uint32_t t, std::size_t k) {
  return mesh.vertex_position[mesh.triangle_vertex[3 * t + k]];
}

/// The triangles that remain of a mesh, and their area.
struct Kept {
  std::unique_ptr<Context> context = std::make_unique<Context>();  ///< charged with the cuts
  BorderCuts cuts;
  double area = 0;
  double least_part = 1;  ///< area
};

Kept kept(const mesh::TriangleMesh& mesh, const Predicate& seen) {
  const auto node_position = [&](std::uint32_t t, std::size_t place) {
    const auto& w = kNodeBarycentric[place];
    return corner(mesh, t, 0) * w[0] + corner(mesh, t, 1) * w[1] + corner(mesh, t, 2) * w[2];
  };
  const auto node_sees = [&](std::uint32_t t, std::size_t i) { return seen(node_position(t, i)); };
  const auto is_seam = [&](std::uint32_t h) {
    return mesh.half_edge_constraint[h] != mesh::kNone && mesh.half_edge_twin[h] != mesh::kNone;
  };
  const auto look = [&](std::span<const Vec2> points, std::span<std::uint8_t> out) {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = seen(points[i]);
    return ok_status();
  };
  Kept result;
  Result<BorderCuts> cuts = cut_at_border(*result.context, mesh, {node_sees, is_seam, look}, 1e-6);
  EXPECT_TRUE(cuts.ok());
  result.cuts = std::move(*cuts);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    const bool is_cut = !result.cuts.is_cut.empty() && result.cuts.is_cut[t];
    if (is_cut || !node_sees(t, 9)) continue;
    result.area +=
        cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0)) / 2;
  }
  const auto position = [&](std::uint32_t vertex) {
    const std::size_t own = mesh.vertex_position.size();
    return vertex < own ? mesh.vertex_position[vertex] : result.cuts.vertex[vertex - own];
  };
  for (std::size_t i = 0; i < result.cuts.part_count(); ++i) {
    const Vec2 p = position(result.cuts.triangle_vertex[3 * i]);
    const double area = cross(position(result.cuts.triangle_vertex[3 * i + 1]) - p,
                              position(result.cuts.triangle_vertex[3 * i + 2]) - p) /
                        2;
    result.area += area;
    result.least_part = std::min(result.least_part, area);
  }
  return result;
}

TEST(Border, where_all_is_seen_nothing_is_cut) {
  const mesh::TriangleMesh mesh = grid_mesh();
  for (bool all : {true, false}) {
    const Kept result = kept(mesh, [&](Vec2) { return all; });
    EXPECT_EQ(result.cuts.part_count(), 0u);
    EXPECT_TRUE(result.cuts.is_cut.empty());
  }
}

TEST(Border, triangles_end_at_a_straight_border) {
  const mesh::TriangleMesh mesh = grid_mesh();
  const double whole = kept(mesh, [](Vec2) { return true; }).area;
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const double angle = 2 * std::numbers::pi * (random() / 4294967296.0);
    const Vec2 normal{std::cos(angle), std::sin(angle)};
    const Vec2 through{20.0 + random() % 60, 20.0 + random() % 60};
    const auto side = [&](Vec2 p) { return dot(normal, p - through); };
    const Kept seen = kept(mesh, [&](Vec2 p) { return side(p) > 0; });
    const Kept unseen = kept(mesh, [&](Vec2 p) { return side(p) <= 0; });
    // No parts overlap, so the two together are the whole.
    EXPECT_NEAR(seen.area + unseen.area, whole, 1e-3) << i;
    EXPECT_GT(seen.least_part, -1e-9);
    EXPECT_GT(seen.cuts.part_count(), 5u);
    for (Vec2 p : seen.cuts.vertex) EXPECT_NEAR(side(p), 0, 0.02) << i;
    for (Vec2 p : seen.cuts.point) EXPECT_GT(side(p), -0.01) << i;
  }
}

TEST(Border, a_border_through_vertices_is_followed) {
  const mesh::TriangleMesh mesh = grid_mesh();
  const double whole = kept(mesh, [](Vec2) { return true; }).area;
  for (std::size_t i = 0; i + 40 < mesh.vertex_position.size(); i += 7) {
    const Vec2 a = mesh.vertex_position[i], b = mesh.vertex_position[i + 40];
    const auto seen = [&](Vec2 p) { return cross(b - a, p - a) > 0; };
    const Kept one = kept(mesh, seen);
    const Kept other = kept(mesh, [&](Vec2 p) { return !seen(p); });
    EXPECT_NEAR(one.area + other.area, whole, 1e-3);
    EXPECT_GT(one.least_part, -1e-9);
  }
}

TEST(Border, a_wedge_keeps_its_area_but_for_its_tip) {
  const mesh::TriangleMesh mesh = grid_mesh();
  for (double slope : {0.1, 0.4, 1.0, 3.0}) {
    const Vec2 tip{21.3, 48.7};
    const auto in_wedge = [&](Vec2 p) { return std::fabs(p.y - tip.y) < slope * (p.x - tip.x); };
    const Kept inside = kept(mesh, in_wedge);
    const Kept outside = kept(mesh, [&](Vec2 p) { return !in_wedge(p); });
    const double whole = kept(mesh, [](Vec2) { return true; }).area;
    // In the triangle of the tip the border is not straight.
    EXPECT_NEAR(inside.area + outside.area, whole, 15) << slope;
    EXPECT_GT(inside.least_part, -1e-9);
    EXPECT_GT(outside.least_part, -1e-9);
  }
}

TEST(Border, what_nobody_waits_for_is_left) {
  const mesh::TriangleMesh mesh = grid_mesh();
  Context context;
  context.cancel = true;
  const auto node_sees = [](std::uint32_t t, std::size_t) { return t % 2 == 0; };
  const auto is_seam = [](std::uint32_t) { return false; };
  const auto look = [](std::span<const Vec2>, std::span<std::uint8_t>) { return ok_status(); };
  const Result<BorderCuts> cuts = cut_at_border(context, mesh, {node_sees, is_seam, look}, 1e-6);
  EXPECT_TRUE(!cuts.ok() || cuts->part_count() == 0);
}

}  // namespace
}  // namespace sfumato::solve
