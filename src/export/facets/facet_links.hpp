#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/facets.hpp"

namespace sfumato::outputs {

inline constexpr std::uint32_t kNoEdge = 0xffffffff;

/// Half-edge 3 f + k of a facet mesh runs from corner k of facet f to the next one.
constexpr std::uint32_t next_edge(std::uint32_t edge) {
  return edge % 3 == 2 ? edge - 2 : edge + 1;
}
constexpr std::uint32_t previous_edge(std::uint32_t edge) {
  return edge % 3 == 0 ? edge + 2 : edge - 1;
}

/// Which facets lie side by side, by the positions of their corners: values may differ there.
struct FacetLinks {
  std::vector<std::uint32_t> twin;  ///< per half-edge: that which runs back, or kNoEdge
  TableMemory memory{"the edges of facets"};
};

/// Where more than two facets share an edge, they are paired in their order. Errors: limit,
/// cancelled. Cost: O(n log n).
Result<FacetLinks> link_facets(Context& context, const FacetMesh& mesh);

}  // namespace sfumato::outputs
