#pragma once

#include <cstdint>
#include <vector>

#include "base/half_edge.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The edges of a layer that lie on curves. Each is listed once, by the half-edge (3 triangle +
/// side) of one of its sides; along a curve this is always the same side, except at junctions.
struct CurveEdges {
  std::vector<std::uint32_t> twin;  ///< per half-edge: the one on the other side; kNoHalfEdge: none
  std::vector<std::uint32_t> side;  ///< one half-edge of each edge
  /// For each half-edge of `side` and its twin: the next one along the curve, on the same side;
  /// kNoHalfEdge for other half-edges, at ends and at junctions.
  std::vector<std::uint32_t> onward;
  TableMemory memory{"edges on curves"};
};

/// Errors: limit (memory). Cost: O(n log n) in the triangles.
Result<CurveEdges> find_curve_edges(Context& context, const PatchLayer& layer);

}  // namespace sfumato::outputs
