#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "export/facet_grid.hpp"
#include "export/facet_patch.hpp"

namespace sfumato::outputs {

/// An edge of one patch, or of two whose four nodes on it are the same.
struct FacetEdge {
  std::uint32_t half_edge = 0;  ///< 3 triangle + side of the first patch that has it
  std::uint8_t cuts = 1;
};

/// How the patches of a layer are cut, so that neighbours agree.
struct FacetCuts {
  std::vector<std::uint8_t> grid;      ///< per triangle
  std::vector<std::uint32_t> edge_of;  ///< per triangle and side: index into `edge`
  std::vector<FacetEdge> edge;
  ScopedCharge charge;

  PatchCut of(std::uint32_t triangle) const;
};

/// Every patch as fine as `max_error` asks for and `smallest_side` allows; edges between the same
/// two vertices as fine as the finest patch at them. Errors: limit, cancelled.
Result<FacetCuts> find_cuts(Context& context, const PatchLayer& layer, InterpolationSpace space,
                            const FacetSource& source, double max_error, double smallest_side);

}  // namespace sfumato::outputs
