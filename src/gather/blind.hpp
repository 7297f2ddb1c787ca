#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Half-edges that rays may walk through and behind which they meet no side that stops them: the
/// walk need not follow them. Two reasons are found, exactly but for what rounding to the lattice
/// lets a ray graze:
///
/// - all hit edges lie on the near side of the half-edge's line, or on it;
/// - it is an open side of a curve, and no hit edge that can be reached behind it faces it: as from
///   the insides of concentric circles that bear colours outside, and behind parallel lines.
///
/// Without this, rays that pass the open side of a curve would be cut at each vertex of it, and
/// walked on to the border piece by piece.
///
/// code     per half-edge of the mesh: an EdgeCode; which passage or hit edge it is does not matter
/// memory   the result's room is taken from it
/// Returns  per half-edge 1 where it is blind. Not every blind half-edge is found: the work is at
///          most a constant for each, which ordinary drawings use a small part of. None are found
///          where the mesh has no lattice.
/// Cost     O(h log h) for h half-edges.
/// Errors   limit (memory), cancelled.
Result<std::vector<std::uint8_t>> find_blind(Context& context, const mesh::TriangleMesh& mesh,
                                             std::span<const EdgeCode> code, TableMemory& memory);

}  // namespace sfumato::gather
