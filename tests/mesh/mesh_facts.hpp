#pragma once

#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"

/// Properties of a mesh for tests.
namespace sfumato::mesh::test {

/// Returns the constraint between the vertices at p and q, in either direction.
std::optional<Constraint> constraint_between(const TriangleMesh& mesh, Vec2 p, Vec2 q);

/// A piece of one segment, oriented so that u_from <= u_to.
struct PlacedPiece {
  Vec2 from;
  Vec2 to;
  float u_from;
  float u_to;
};
std::vector<PlacedPiece> pieces_of_segment(const TriangleMesh& mesh, std::uint32_t segment);

/// Returns the same for all segments at once, by segment index.
std::vector<std::vector<PlacedPiece>> pieces_by_segment(const TriangleMesh& mesh,
                                                        std::size_t segment_count);

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

/// Returns the smallest angle in degrees.
double smallest_angle(const TriangleMesh& mesh, std::uint32_t t);

double area(const TriangleMesh& mesh, std::uint32_t t);
double total_area(const TriangleMesh& mesh);

/// Returns 64-bit FNV-1a over lattice coordinates, corners and constraints.
std::uint64_t mesh_hash(const TriangleMesh& mesh);

}  // namespace sfumato::mesh::test
