#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "import/arrangement.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// An edge of a loop, and the stretch of a contour that the loop follows there.
struct LoopStep {
  std::size_t edge = 0;
  Source source;
};

/// Edges one after another, each from where the previous one ends, the first from where the last
/// ends.
struct EdgeLoops {
  std::vector<LoopStep> step;
  std::vector<std::size_t> begin;  ///< of each loop in `step`, and the end of the last
  TableMemory memory{"the boundary of a shape"};

  std::size_t size() const { return begin.size() - 1; }
  std::span<const LoopStep> steps_of(std::size_t loop) const {
    return std::span(step).subspan(begin[loop], begin[loop + 1] - begin[loop]);
  }
};

/// Returns whether a stretch begins where the other ends, and runs on in its direction.
bool goes_on_from(const Source& before, const Source& after);

/// Returns the signed area of a loop: the area of the polygon of its edges.
double area_of(const BoundaryEdges& edges, const EdgeLoops& loops, std::size_t loop);

/// Links edges into loops, which follow a contour where possible. Sorts the edges. Errors: limit
/// (memory), cancelled. Cost: O(n log n).
Result<EdgeLoops> link_edges(Context& context, BoundaryEdges& edges);

}  // namespace sfumato::svg_import
