#include "solve/fields/nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/mesher.hpp"
#include "support/drawing.hpp"

namespace sfumato::solve {
namespace {

using test::colored;
using test::straight_curve;

struct LaidOut {
  mesh::TriangleMesh mesh;
  NodeLayout layout;

  Vec2 corner(std::uint32_t t, int k) const {
    return mesh.vertex_position[mesh.triangle_vertex[3 * t + k]];
  }
  std::uint32_t node(std::uint32_t t, int place) const {
    return layout.triangle_node[node_slot(t, place)];
  }
  Rgb value(std::uint32_t t, int place) const {
    const float* v = layout.value.data() + 3 * std::size_t{node(t, place)};
    return {v[0], v[1], v[2]};
  }
  Vec2 barycentre(std::uint32_t t) const {
    return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3;
  }
};

LaidOut laid_out(const std::vector<Curve>& curves) {
  Context context;
  Result<curves::FlatCurves> flat = curves::flatten(context, curves, {});
  TableMemory memory("a test");
  const curves::SegmentAttributes attributes =
      *curves::sample_colors(context, *flat, curves, InterpolationSpace::srgb, memory);
  mesh::MeshOptions options;
  options.frame = {{-1, -1}, {101, 101}};
  options.unit_size = 0.1;
  options.max_area = 20;
  Result<mesh::Mesher> mesher = mesh::Mesher::build(context, *flat, options);
  EXPECT_TRUE(mesher.ok());
  EXPECT_TRUE(mesher->refine(context).ok());
  LaidOut result;
  result.mesh = *mesher->patch_mesh({});
  const Result<Seams> seams = Seams::create(context, result.mesh, attributes);
  result.layout = *lay_out_nodes(context, result.mesh, attributes, *seams, memory);
  return result;
}

std::vector<Curve> one_line() {
  return {colored(straight_curve({20, 50}, {80, 50}), test::kWhite, test::kBlack)};
}

TEST(Nodes, every_place_of_every_triangle_has_a_node) {
  const LaidOut laid = laid_out(one_line());
  for (std::uint32_t node : laid.layout.triangle_node) {
    ASSERT_LT(node, laid.layout.node_count());
  }
}

TEST(Nodes, triangles_share_the_nodes_of_a_free_edge_and_only_of_a_free_edge) {
  const LaidOut laid = laid_out(one_line());
  int free_edges = 0, curve_edges = 0;
  for (std::uint32_t h = 0; h < laid.mesh.half_edge_twin.size(); ++h) {
    const std::int32_t twin = laid.mesh.half_edge_twin[h];
    if (twin == mesh::kNone) continue;
    const int k = static_cast<int>(h % 3), j = twin % 3;
    const auto t = h / 3, u = static_cast<std::uint32_t>(twin) / 3;
    if (laid.layout.edge_is_curve[h]) {
      ++curve_edges;
      EXPECT_NE(laid.node(t, 3 + 2 * k), laid.node(u, 4 + 2 * j));
    } else {
      ++free_edges;
      EXPECT_EQ(laid.node(t, 3 + 2 * k), laid.node(u, 4 + 2 * j));
      EXPECT_EQ(laid.node(t, 4 + 2 * k), laid.node(u, 3 + 2 * j));
    }
  }
  EXPECT_GT(free_edges, 0);
  EXPECT_GT(curve_edges, 0);
}

TEST(Nodes, nodes_on_a_curve_have_the_colour_of_their_side) {
  const LaidOut laid = laid_out(one_line());
  for (std::uint32_t h = 0; h < laid.mesh.half_edge_twin.size(); ++h) {
    if (!laid.layout.edge_is_curve[h]) continue;
    const std::uint32_t t = h / 3;
    // The left of a line to the right is above it on the screen.
    const Rgb expected = laid.barycentre(t).y < 50 ? test::kWhite : test::kBlack;
    for (int place : {3 + 2 * static_cast<int>(h % 3), 4 + 2 * static_cast<int>(h % 3)}) {
      EXPECT_TRUE(laid.layout.is_fixed[laid.node(t, place)]);
      EXPECT_EQ(laid.value(t, place), expected);
    }
  }
}

TEST(Nodes, free_nodes_stand_where_their_barycentric_coordinates_say) {
  const LaidOut laid = laid_out(one_line());
  for (std::uint32_t t = 0; t < laid.mesh.triangle_count(); ++t) {
    const Vec2 centre = laid.layout.position[laid.node(t, 9)];
    EXPECT_NEAR(length(centre - laid.barycentre(t)), 0, 1e-9);
    for (int k = 0; k < 3; ++k) {
      if (laid.layout.edge_is_curve[3 * t + k]) continue;
      const Vec2 near = laid.layout.position[laid.node(t, 3 + 2 * k)];
      const Vec2 expected = lerp(laid.corner(t, k), laid.corner(t, (k + 1) % 3), 1.0 / 3);
      EXPECT_NEAR(length(near - expected), 0, 1e-9);
    }
  }
}

TEST(Nodes, at_a_crossing_each_sector_turns_from_one_curve_to_the_next) {
  // Four quadrants around (50, 50): each is bounded by one side of each curve.
  const LaidOut laid =
      laid_out({colored(straight_curve({20, 50}, {80, 50}), test::kWhite, test::kBlack),
                colored(straight_curve({50, 20}, {50, 80}), test::kRed, test::kBlue)});
  int corners = 0;
  for (std::uint32_t t = 0; t < laid.mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (!(laid.corner(t, k) == Vec2{50, 50})) continue;
      ++corners;
      const Vec2 d = laid.barycentre(t) - Vec2{50, 50};
      const Rgb along_x = d.y < 0 ? test::kWhite : test::kBlack;
      const Rgb along_y =
          d.x > 0 ? test::kRed : test::kBlue;  // left of a line downwards is the right
      const double fraction = std::atan2(std::fabs(d.y), std::fabs(d.x)) / (std::acos(-1.0) / 2);
      const Rgb expected = lerp(along_x, along_y, static_cast<float>(fraction));
      const Rgb value = laid.value(t, k);
      EXPECT_NEAR(value.r, expected.r, 1e-5);
      EXPECT_NEAR(value.g, expected.g, 1e-5);
      EXPECT_NEAR(value.b, expected.b, 1e-5);
    }
  }
  EXPECT_GE(corners, 4);
}

TEST(Nodes, an_open_side_has_free_nodes_beside_the_curve) {
  Curve curve = straight_curve({20, 50}, {80, 50});
  curve.left.color = test::one_color(test::kWhite);
  const LaidOut laid = laid_out({curve});
  int open = 0;
  for (std::uint32_t h = 0; h < laid.mesh.half_edge_twin.size(); ++h) {
    if (!laid.layout.edge_is_curve[h] || laid.barycentre(h / 3).y < 50) continue;
    const std::uint32_t node = laid.node(h / 3, 3 + 2 * static_cast<int>(h % 3));
    ++open;
    EXPECT_FALSE(laid.layout.is_fixed[node]);
    EXPECT_GT(laid.layout.position[node].y, 50);
  }
  EXPECT_GT(open, 0);
}

TEST(Nodes, a_curve_without_colours_leaves_no_seam) {
  const LaidOut laid = laid_out({straight_curve({20, 50}, {80, 50})});
  EXPECT_EQ(std::count(laid.layout.edge_is_curve.begin(), laid.layout.edge_is_curve.end(), 1), 0);
  EXPECT_EQ(std::count(laid.layout.is_fixed.begin(), laid.layout.is_fixed.end(), 1), 0);
}

TEST(Nodes, there_are_about_five_nodes_to_a_triangle) {
  const LaidOut laid = laid_out(one_line());
  const double per_triangle = static_cast<double>(laid.layout.node_count()) /
                              static_cast<double>(laid.mesh.triangle_count());
  EXPECT_GT(per_triangle, 4);
  EXPECT_LT(per_triangle, 6.5);
}

}  // namespace
}  // namespace sfumato::solve
