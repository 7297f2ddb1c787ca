#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

/// What tests ask of a mesh.
namespace sfumato::mesh::test {

/// The constraint between the vertices at p and q, in either direction.
std::optional<Constraint> constraint_between(const TriangleMesh& mesh, Vec2 p, Vec2 q);

/// The pieces of one segment, each turned so that u_from <= u_to, in the order of u.
struct PlacedPiece {
  Vec2 from;
  Vec2 to;
  float u_from;
  float u_to;
};
std::vector<PlacedPiece> pieces_of_segment(const TriangleMesh& mesh, std::uint32_t segment);

/// The same for all segments at once, by segment index.
std::vector<std::vector<PlacedPiece>> pieces_by_segment(const TriangleMesh& mesh,
                                                        std::size_t segment_count);

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

/// Degrees.
double smallest_angle(const TriangleMesh& mesh, std::uint32_t t);

double area(const TriangleMesh& mesh, std::uint32_t t);
double total_area(const TriangleMesh& mesh);
double longest_edge(const TriangleMesh& mesh, std::uint32_t t);

/// 64-bit FNV-1a over lattice coordinates, corners and constraints.
std::uint64_t mesh_hash(const TriangleMesh& mesh);

}  // namespace sfumato::mesh::test
