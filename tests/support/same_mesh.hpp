#pragma once

#include <algorithm>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace sfumato::test {

inline bool same_piece(const mesh::SegmentPiece& a, const mesh::SegmentPiece& b) {
  return a.segment == b.segment && a.u_from == b.u_from && a.u_to == b.u_to;
}

/// Returns whether the same constraint lies on half-edge h of both meshes.
inline bool same_constraint(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                            std::size_t h) {
  const std::int32_t in_a = a.half_edge_constraint[h], in_b = b.half_edge_constraint[h];
  if (in_a == mesh::kNone || in_b == mesh::kNone) return in_a == in_b;
  const mesh::Constraint &c = a.constraint[in_a], &d = b.constraint[in_b];
  return c.from == d.from && c.to == d.to &&
         std::ranges::equal(a.pieces(c), b.pieces(d), same_piece);
}

/// Returns the difference of two meshes without their lists of constraints, comparing only the
/// edges; empty: none.
inline std::string difference_on_edges(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
  if (a.lattice_step != b.lattice_step) return "lattice step";
  if (a.vertex_position != b.vertex_position) return "vertices";
  if (a.triangle_vertex != b.triangle_vertex) return "triangles";
  if (a.half_edge_twin != b.half_edge_twin) return "twins";
  if (a.half_edge_constraint.size() != b.half_edge_constraint.size()) return "half-edges";
  for (std::size_t h = 0; h < a.half_edge_constraint.size(); ++h) {
    if (!same_constraint(a, b, h)) return "what lies on half-edge " + std::to_string(h);
  }
  return "";
}

/// Returns the difference of two meshes, ignoring the numbers of their constraints; empty: none.
inline std::string difference_of(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b) {
  if (a.constraint.size() != b.constraint.size()) return "number of constraints";
  if (a.piece.size() != b.piece.size()) return "number of pieces";
  return difference_on_edges(a, b);
}

}  // namespace sfumato::test
