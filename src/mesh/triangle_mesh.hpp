#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/half_edge.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::mesh {

inline constexpr std::int32_t kNone = -1;

/// A stretch of a flattened segment: fractions of the segment (0 at its first vertex, 1 at its
/// second) at the two ends of a constrained edge, in the constraint's own direction.
struct SegmentPiece {
  std::uint32_t segment = 0;
  float u_from = 0;
  float u_to = 1;  ///< less than u_from if the segment runs against the constraint
};

/// An edge of the mesh with curves on it, or only the frame.
struct Constraint {
  std::uint32_t from = 0;  ///< vertex
  std::uint32_t to = 0;    ///< vertex
  std::uint32_t piece_begin = 0;
  std::uint32_t piece_end = 0;  ///< pieces [begin, end): in drawing order; none: frame only
};

/// A triangulation in flat index arrays. Half-edge h = 3 t + k runs from corner k of triangle t to
/// corner (k + 1) % 3; t lies on the side where cross(edge, p - start) > 0, which is the *right* of
/// the edge on the screen (y down).
struct TriangleMesh {
  double lattice_step = 0;  ///< a power of two, user units: positions are whole multiples of it
  std::vector<Vec2> vertex_position;               ///< layer frame
  std::vector<std::uint32_t> triangle_vertex;      ///< 3 per triangle, positive orientation
  std::vector<std::int32_t> half_edge_twin;        ///< kNone on the hull
  std::vector<std::int32_t> half_edge_constraint;  ///< index into `constraint`, or kNone: free
  std::vector<Constraint> constraint;
  std::vector<SegmentPiece> piece;

  std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(triangle_vertex.size() / 3);
  }
  std::uint32_t origin(std::uint32_t h) const { return triangle_vertex[h]; }
  std::uint32_t target(std::uint32_t h) const { return triangle_vertex[next_half_edge(h)]; }
  std::uint32_t apex(std::uint32_t h) const { return triangle_vertex[previous_half_edge(h)]; }
  std::span<const SegmentPiece> pieces(const Constraint& c) const {
    return {piece.data() + c.piece_begin, piece.data() + c.piece_end};
  }
  /// Returns whether a curve lies on the half-edge. False for free edges and where only the frame
  /// runs.
  bool has_curves(std::uint32_t h) const {
    const std::int32_t c = half_edge_constraint[h];
    return c != kNone && !pieces(constraint[static_cast<std::size_t>(c)]).empty();
  }
  /// Returns whether a segment s with is_chosen[s] lies on the half-edge.
  bool has_segment(std::uint32_t h, std::span<const std::uint8_t> is_chosen) const {
    const std::int32_t c = half_edge_constraint[h];
    if (c == kNone) return false;
    for (const SegmentPiece& on_edge : pieces(constraint[static_cast<std::size_t>(c)])) {
      if (is_chosen[on_edge.segment] != 0) return true;
    }
    return false;
  }
};

/// Returns the length of a triangle's longest edge.
inline double longest_edge(const TriangleMesh& mesh, std::uint32_t triangle) {
  double longest = 0;
  for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    const Vec2 from = mesh.vertex_position[mesh.origin(h)];
    longest = std::max(longest, length(mesh.vertex_position[mesh.target(h)] - from));
  }
  return longest;
}

}  // namespace sfumato::mesh
