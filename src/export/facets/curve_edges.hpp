#pragma once

#include <cstdint>
#include <vector>

#include "base/half_edge.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The edges of a layer that lie on curves, each once, by the half-edge (3 triangle + side) of one
/// of its sides: along a curve always the same side, but at junctions.
struct CurveEdges {
  std::vector<std::uint32_t> twin;  ///< per half-edge the one across; kNoHalfEdge: none
  std::vector<std::uint32_t> side;  ///< one half-edge of each edge
  /// Per half-edge of `side`, and of their twins: the one that goes on along the curve, on the same
  /// side of it; kNoHalfEdge elsewhere, at ends and junctions.
  std::vector<std::uint32_t> onward;
  TableMemory memory{"edges on curves"};
};

/// Errors: limit (memory). Cost: O(n log n) in the triangles.
Result<CurveEdges> find_curve_edges(Context& context, const PatchLayer& layer);

}  // namespace sfumato::outputs
