#include "export/facets/underlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "raster/pictures.hpp"

namespace sfumato::outputs {
namespace {

const Box kSmallBox{{0, 0}, {10, 8}};
constexpr double kUnderlapReach = 0.8;

/// Returns patches of a jittered grid as separate facets, in a random order.
FacetMesh facets(std::uint32_t seed) {
  const test::RegionMesh grid = test::jittered_grid(kSmallBox, 6, seed);
  FacetMesh mesh;
  mesh.channel_count = 1;
  mesh.vertex_position = grid.vertex;
  mesh.vertex_value.assign(grid.vertex.size(), 1);
  std::vector<test::Corners> triangles = grid.triangle;
  std::mt19937 random(seed);
  for (std::size_t i = triangles.size(); i > 1; --i)
    std::swap(triangles[i - 1], triangles[random() % i]);
  for (const test::Corners& corners : triangles)
    mesh.facet_vertex.insert(mesh.facet_vertex.end(), corners.begin(), corners.end());
  return mesh;
}

FacetLinks linked(const FacetMesh& mesh) {
  static Context context;  // must outlive the tables charged to it
  return std::move(*link_facets(context, mesh));
}

FacetOutlines outlined(const FacetMesh& mesh, double outside) {
  static Context context;  // must outlive the tables charged to it
  return std::move(*underlapped(context, mesh, linked(mesh), {kUnderlapReach, outside}));
}

/// Returns how often a closed line goes around a point.
int winding(std::span<const Vec2> line, Vec2 p) {
  double angle = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i] - p, b = line[(i + 1) % line.size()] - p;
    angle += std::atan2(cross(a, b), dot(a, b));
  }
  return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

bool contains(const FacetMesh& mesh, std::uint32_t facet, Vec2 p) {
  const Vec2 corner[3] = {mesh.vertex_position[mesh.facet_vertex[3 * facet]],
                          mesh.vertex_position[mesh.facet_vertex[3 * facet + 1]],
                          mesh.vertex_position[mesh.facet_vertex[3 * facet + 2]]};
  return winding(corner, p) != 0;
}

std::uint32_t facet_count(const FacetMesh& mesh) {
  return static_cast<std::uint32_t>(mesh.facet_vertex.size() / 3);
}

/// Returns the facet that shows at a point when outlines are painted in order.
std::optional<std::uint32_t> uppermost(const FacetOutlines& outlines, std::uint32_t count, Vec2 p) {
  for (std::uint32_t facet = count; facet-- > 0;)
    if (winding(outlines.of(facet), p) != 0) return facet;
  return std::nullopt;
}

TEST(Underlap, what_shows_is_the_facets) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const FacetMesh mesh = facets(seed);
    const FacetOutlines outlines = outlined(mesh, kUnderlapReach);
    std::mt19937 random(seed);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p{10 * (random() / 4294967296.0), 8 * (random() / 4294967296.0)};
      const auto shown = uppermost(outlines, facet_count(mesh), p);
      ASSERT_TRUE(shown);
      EXPECT_TRUE(contains(mesh, *shown, p)) << seed << ": " << p.x << ", " << p.y;
    }
  }
}

TEST(Underlap, beside_every_inner_edge_the_earlier_facet_lies_below) {
  const FacetMesh mesh = facets(7);
  const FacetLinks links = linked(mesh);
  const FacetOutlines outlines = outlined(mesh, 0);
  int edges = 0;
  for (std::uint32_t edge = 0; edge < mesh.facet_vertex.size(); ++edge) {
    const std::uint32_t twin = links.twin[edge];
    if (twin == kNoHalfEdge || twin < edge) continue;
    const Vec2 a = mesh.vertex_position[mesh.facet_vertex[edge]];
    const Vec2 b = mesh.vertex_position[mesh.facet_vertex[next_half_edge(edge)]];
    const Vec2 beside = lerp(a, b, 0.5) + left_of(b - a) / length(b - a) * 0.05;
    EXPECT_TRUE(contains(mesh, twin / 3, beside));
    EXPECT_NE(winding(outlines.of(edge / 3), beside), 0) << edge;
    ++edges;
  }
  EXPECT_GT(edges, 80);
}

TEST(Underlap, the_first_facet_at_a_corner_lies_below_all_others_there) {
  const FacetMesh mesh = facets(9);
  const FacetOutlines outlines = outlined(mesh, 0);
  int corners = 0;
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_position.size(); ++vertex) {
    const Vec2 corner = mesh.vertex_position[vertex];
    const bool is_inner = corner.x > 0.1 && corner.x < 9.9 && corner.y > 0.1 && corner.y < 7.9;
    if (!is_inner) continue;
    const auto first = std::ranges::find(mesh.facet_vertex, vertex) - mesh.facet_vertex.begin();
    for (int k = 0; k < 16; ++k) {
      const double angle = std::numbers::pi * (k + 0.37) / 8;
      const Vec2 p = corner + Vec2{std::cos(angle), std::sin(angle)} * 0.02;
      EXPECT_NE(winding(outlines.of(static_cast<std::uint32_t>(first / 3)), p), 0) << vertex;
    }
    ++corners;
  }
  EXPECT_EQ(corners, 25);
}

TEST(Underlap, reaches_beyond_the_mesh_only_where_it_is_asked_to) {
  const FacetMesh mesh = facets(3);
  const FacetOutlines inside = outlined(mesh, 0), beyond = outlined(mesh, kUnderlapReach);
  for (const Vec2 p :
       {Vec2{5, -0.3}, Vec2{-0.3, 4}, Vec2{10.3, 4}, Vec2{5, 8.3}, Vec2{-0.2, -0.2}}) {
    EXPECT_FALSE(uppermost(inside, facet_count(mesh), p)) << p.x << ", " << p.y;
    EXPECT_TRUE(uppermost(beyond, facet_count(mesh), p)) << p.x << ", " << p.y;
  }
}

TEST(Silhouette, goes_around_the_mesh_and_knows_the_frame) {
  FacetMesh mesh = facets(4);
  Context context;
  const Silhouette whole = std::move(*silhouette(context, mesh, linked(mesh), kSmallBox));
  ASSERT_EQ(whole.loops.size(), 1u);
  EXPECT_TRUE(whole.is_frame);
  EXPECT_EQ(std::abs(winding(whole.loops[0], {5, 4})), 1);
  EXPECT_FALSE(silhouette(context, mesh, linked(mesh), kSmallBox.grown_by(1))->is_frame);
  mesh.facet_vertex.erase(mesh.facet_vertex.begin() + 60, mesh.facet_vertex.begin() + 63);
  const Silhouette broken = std::move(*silhouette(context, mesh, linked(mesh), kSmallBox));
  EXPECT_FALSE(broken.is_frame && broken.loops.size() == 1);
}

TEST(SmallFacets, are_grown_and_stay_away_from_the_end) {
  const FacetMesh mesh = facets(5);
  const FacetLinks links = linked(mesh);
  Context context;
  TableMemory memory("a test");
  const auto all = *small_facets(context, mesh, links, 100, 0.1, false, memory);
  EXPECT_EQ(all.size(), facet_count(mesh));
  for (const SmallFacet& small : all) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vec2 corner = mesh.vertex_position[mesh.facet_vertex[3 * small.facet + k]];
      EXPECT_NE(winding(small.grown, corner), 0);
      EXPECT_LE(length(small.grown[k] - corner), 0.3 + 1e-9);
    }
  }
  EXPECT_TRUE(small_facets(context, mesh, links, 1e-9, 0.1, false, memory)->empty());
  const auto inner = *small_facets(context, mesh, links, 100, 0.1, true, memory);
  for (const SmallFacet& small : inner)
    for (const Vec2 p : small.grown) EXPECT_TRUE(kSmallBox.contains(p));
}

}  // namespace
}  // namespace sfumato::outputs
