#include <utility>

#include "gather/scene/scene.hpp"

namespace sfumato::gather {
namespace {

/// The side of a piece that faces half-edge h, and the piece's fractions at h's origin and target.
struct FacingPiece {
  const curves::SegmentSide* side;
  float u_origin;
  float u_target;
};

// The half-edge's triangle lies on its right on the screen, hence on the right of a segment with
// the same direction.
FacingPiece facing_piece(const curves::SegmentAttributes& attributes,
                         const mesh::SegmentPiece& piece, bool half_edge_runs_as_constraint) {
  const bool segment_runs_as_constraint = piece.u_from <= piece.u_to;
  const bool same_way = segment_runs_as_constraint == half_edge_runs_as_constraint;
  const auto& side = same_way ? attributes.right : attributes.left;
  if (half_edge_runs_as_constraint) return {&side[piece.segment], piece.u_from, piece.u_to};
  return {&side[piece.segment], piece.u_to, piece.u_from};
}

/// Returns how far a piece lay to the side of the half-edge's triangle before the weld moved it,
/// user units.
double reach_to_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                     const mesh::SegmentPiece& piece, std::uint32_t half_edge) {
  const Vec2 origin = mesh.vertex_position[mesh.origin(half_edge)];
  const Vec2 along = mesh.vertex_position[mesh.target(half_edge)] - origin;
  const Vec2 middle = lerp(attributes.vertex[piece.segment], attributes.vertex[piece.segment + 1],
                           0.5 * (double{piece.u_from} + double{piece.u_to}));
  return cross(along, middle - origin) / length(along);
}

}  // namespace

Facing facing_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                   std::uint32_t half_edge) {
  const mesh::Constraint& constraint =
      mesh.constraint[static_cast<std::size_t>(mesh.half_edge_constraint[half_edge])];
  const bool runs_as_constraint = mesh.origin(half_edge) == constraint.from;
  Facing facing;
  std::uint32_t owner = 0;
  double reach = 0;
  for (std::uint32_t i = constraint.piece_end; i > constraint.piece_begin; --i) {
    const mesh::SegmentPiece& piece = mesh.piece[i - 1];
    const bool first = facing.kind == ShaderKind::open;
    if (!first && attributes.curve[piece.segment] != owner) break;
    const FacingPiece facing_it = facing_piece(attributes, piece, runs_as_constraint);
    const curves::SegmentSide& side = *facing_it.side;
    if (side.kind == ShaderKind::open) continue;
    const double piece_reach = reach_to_side(mesh, attributes, piece, half_edge);
    // Within a lattice step two passages are the same line, and the last counts.
    if (!first && piece_reach <= reach + mesh.lattice_step) continue;
    const auto& [start, end] = side.value;
    const auto& [blur_start, blur_end] = side.blur_radius;
    const auto& [fine_start, fine_end] = side.fine_radius;
    facing = {side.kind,
              side.shader,
              lerp(start, end, facing_it.u_origin),
              lerp(start, end, facing_it.u_target),
              attributes.weight[piece.segment],
              lerp(blur_start, blur_end, facing_it.u_origin),
              lerp(blur_start, blur_end, facing_it.u_target),
              lerp(fine_start, fine_end, facing_it.u_origin),
              lerp(fine_start, fine_end, facing_it.u_target)};
    owner = attributes.curve[piece.segment];
    reach = piece_reach;
  }
  return facing;
}

Facing back_side(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes,
                 std::uint32_t half_edge) {
  const std::int32_t twin = mesh.half_edge_twin[half_edge];
  if (twin == mesh::kNone) return {};
  Facing back = facing_side(mesh, attributes, static_cast<std::uint32_t>(twin));
  std::swap(back.from, back.to);
  std::swap(back.blur_from, back.blur_to);
  std::swap(back.fine_from, back.fine_to);
  return back;
}

}  // namespace sfumato::gather
