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

/// The adjacency of facets, by the positions of their corners; their values may differ there.
struct FacetLinks {
  std::vector<std::uint32_t> twin;  ///< per half-edge: the opposite one, or kNoEdge
  TableMemory memory{"the edges of facets"};
};

/// If more than two facets share an edge, they are paired in their order. Errors: limit, cancelled.
/// Cost: O(n log n).
Result<FacetLinks> link_facets(Context& context, const FacetMesh& mesh);

}  // namespace sfumato::outputs
