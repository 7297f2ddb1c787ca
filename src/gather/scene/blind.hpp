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

/// Finds half-edges that rays may walk through and behind which no side stops them, so that the
/// walk need not follow them. Two cases are found, exactly except for rays that graze an edge
/// because of rounding to the lattice:
///
/// - all hit edges lie on the near side of the half-edge's line, or on it;
/// - it is an open side of a curve, and no hit edge that can be reached behind it faces it.
///   Examples are the insides of concentric circles with colours on the outside, and parallel
///   lines.
///
/// Without this, windows that pass the open side of a curve would be split at each of its vertices,
/// and every piece would be walked to the border.
///
/// - `code`: per half-edge of the mesh an EdgeCode; only its kind matters
/// - `memory`: the result is allocated from it
///
/// Returns per half-edge 1 where it is blind. It does not find every blind half-edge: a constant
/// bounds the work for each, and ordinary drawings need a small part of it. In a mesh without a
/// lattice none are found.
/// Cost: O(h log h) for h half-edges.
/// Errors: limit (memory), cancelled.
Result<std::vector<std::uint8_t>> find_blind(Context& context, const mesh::TriangleMesh& mesh,
                                             std::span<const EdgeCode> code, TableMemory& memory);

}  // namespace sfumato::gather
