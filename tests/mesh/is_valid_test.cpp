#include "mesh/is_valid.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "mesh/flat_input.hpp"
#include "mesh/mesher.hpp"

namespace sfumato::mesh::test {
namespace {

TriangleMesh cross_mesh() {
  Context context;
  Result<Mesher> mesher = Mesher::build(
      context, flat_curves({{{10, 50}, {90, 51}}, {{30, 20}, {31, 80}}}), options_100());
  EXPECT_TRUE(mesher.ok());
  return *mesher->visibility_mesh({});
}

/// Returns the first free half-edge with a twin.
std::uint32_t free_edge(const TriangleMesh& mesh) {
  std::uint32_t h = 0;
  while (mesh.half_edge_twin[h] == kNone || mesh.half_edge_constraint[h] != kNone) ++h;
  return h;
}

TEST(IsValid, a_built_mesh_passes) {
  EXPECT_TRUE(is_valid(cross_mesh()).ok());
}

TEST(IsValid, every_kind_of_damage_is_found) {
  const std::pair<const char*, std::function<void(TriangleMesh&)>> damages[] = {
      {"power of two", [](TriangleMesh& m) { m.lattice_step = 0.3; }},
      {"off the lattice", [](TriangleMesh& m) { m.vertex_position[5].x += m.lattice_step / 2; }},
      {"array sizes", [](TriangleMesh& m) { m.half_edge_twin.pop_back(); }},
      {"vertex index", [](TriangleMesh& m) { m.triangle_vertex[4] = 1'000'000; }},
      {"twin out of range", [](TriangleMesh& m) { m.half_edge_twin[4] = 1'000'000; }},
      {"constraint out of range", [](TriangleMesh& m) { m.half_edge_constraint[4] = 1'000'000; }},
      {"twins disagree",
       [](TriangleMesh& m) { std::swap(m.half_edge_twin[free_edge(m)], m.half_edge_twin[0]); }},
      {"differs between the twins",
       [](TriangleMesh& m) { m.half_edge_constraint[free_edge(m)] = 0; }},
      {"ends elsewhere", [](TriangleMesh& m) { m.constraint[0].from ^= 1; }},
      {"not exactly one edge",
       [](TriangleMesh& m) {
         m.constraint.push_back(m.constraint.back());
         m.constraint.back().piece_begin = m.constraint.back().piece_end;
       }},
      {"piece range", [](TriangleMesh& m) { ++m.constraint[0].piece_begin; }},
      {"pieces without", [](TriangleMesh& m) { m.piece.push_back({}); }},
      {"fractions out of range", [](TriangleMesh& m) { m.piece[0].u_to = 1.5f; }},
      {"not positive", [](TriangleMesh& m) { m.vertex_position[0] = m.vertex_position[2]; }},
  };
  for (const auto& [what, damage] : damages) {
    TriangleMesh mesh = cross_mesh();
    damage(mesh);
    const Status status = is_valid(mesh);
    EXPECT_FALSE(status.ok()) << what;
    EXPECT_NE(status.message.find(what), std::string::npos) << what << ": " << status.message;
  }
}

TriangleMesh square_with_diagonal(Vec2 fourth) {
  TriangleMesh mesh;
  mesh.lattice_step = 1;
  mesh.vertex_position = {{0, 0}, {10, 0}, {10, 10}, fourth};
  mesh.triangle_vertex = {0, 1, 2, 0, 2, 3};
  mesh.half_edge_twin = {kNone, kNone, 3, 2, kNone, kNone};
  mesh.half_edge_constraint.assign(6, kNone);
  return mesh;
}

TEST(IsValid, a_square_with_either_diagonal_passes) {
  EXPECT_TRUE(is_valid(square_with_diagonal({0, 10})).ok());
}

TEST(IsValid, a_diagonal_that_is_not_delaunay_is_found) {
  const Status status = is_valid(square_with_diagonal({1, 9}));
  EXPECT_NE(status.message.find("Delaunay"), std::string::npos) << status.message;
}

TEST(IsValid, triangles_that_do_not_fill_their_rectangle_are_found) {
  const Status status = is_valid(square_with_diagonal({-1, 10}));
  EXPECT_NE(status.message.find("fill the domain"), std::string::npos) << status.message;
}

TEST(IsValid, a_hole_is_found) {
  TriangleMesh mesh = cross_mesh();
  // Cuts the mesh open along a free edge.
  const std::uint32_t h = free_edge(mesh);
  mesh.half_edge_twin[mesh.half_edge_twin[h]] = kNone;
  mesh.half_edge_twin[h] = kNone;
  EXPECT_FALSE(is_valid(mesh).ok());
}

}  // namespace
}  // namespace sfumato::mesh::test
