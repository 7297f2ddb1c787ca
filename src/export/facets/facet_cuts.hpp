#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/facet_tree.hpp"
#include "export/facets/facets.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// An edge of one patch, or of two patches with the same four nodes on it.
struct FacetEdge {
  std::uint64_t steps = 0;      ///< EdgeCuts::steps, from its vertex with the lower index
  std::uint32_t half_edge = 0;  ///< 3 triangle + side of the first patch that has it
};

/// The cuts of the edges of a layer's patches.
struct FacetCuts {
  std::vector<std::uint32_t> edge_of;  ///< per triangle and side: index into `edge`
  std::vector<FacetEdge> edge;
  TableMemory memory{"cuts of patches"};

  std::array<EdgeCuts, 3> of(const PatchLayer& layer, std::uint32_t triangle) const;
};

/// Returns whether side k of a triangle runs from its vertex with the lower index; half_edge: 3
/// triangle + k.
bool is_low_first(const PatchLayer& layer, std::uint32_t half_edge);

/// Cuts every edge as finely as `max_error` requires and `smallest_side` allows. The cuts depend on
/// the edge's own nodes alone, so that neighbours agree. Edges between the same two vertices (the
/// two sides of a curve) get the cuts that any of them requires. Errors: limit, cancelled.
Result<FacetCuts> find_cuts(Context& context, const PatchLayer& layer, InterpolationSpace space,
                            const FacetSource& source, double max_error, double smallest_side);

}  // namespace sfumato::outputs
