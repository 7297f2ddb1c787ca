#pragma once

#include <cstdint>
#include <vector>

#include "base/half_edge.hpp"
#include "base/table_memory.hpp"
#include "export/facets/facets.hpp"

namespace sfumato::outputs {

/// The adjacency of facets, by the positions of their corners; their values may differ there.
struct FacetLinks {
  std::vector<std::uint32_t> twin;  ///< per half-edge: the opposite one, or kNoHalfEdge
  TableMemory memory{"the edges of facets"};
};

/// If more than two facets share an edge, they are paired in their order. Errors: limit, cancelled.
/// Cost: O(n log n).
Result<FacetLinks> link_facets(Context& context, const FacetMesh& mesh);

}  // namespace sfumato::outputs
