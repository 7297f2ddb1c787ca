#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/facet_links.hpp"

namespace sfumato::outputs {

/// How far facets reach under their neighbours and beyond the mesh, layer frame.
struct UnderlapReach {
  double inside = 0;
  double outside = 0;  ///< 0: facets do not reach beyond the mesh
};

/// Outlines of facets that can be painted one after another, each antialiased, with no seams
/// between them: a facet reaches under facets that are painted later, and the first facet at a
/// corner reaches under all others there. Only the facets themselves remain visible.
struct FacetOutlines {
  std::vector<Vec2> point;           ///< layer frame
  std::vector<std::uint32_t> first;  ///< facet count + 1
  TableMemory memory{"the outlines of facets"};

  std::span<const Vec2> of(std::uint32_t facet) const {
    return std::span(point).subspan(first[facet], first[facet + 1] - first[facet]);
  }
};

/// Errors: limit, cancelled. Cost: O(facets).
Result<FacetOutlines> underlapped(Context& context, const FacetMesh& mesh, const FacetLinks& links,
                                  const UnderlapReach& reach);

/// A facet too small for that: the background shows through in pixels that it shares with its
/// neighbours. It must first be painted enlarged by `margin` on all sides.
struct SmallFacet {
  std::uint32_t facet = 0;
  std::array<Vec2, 3> grown;  ///< layer frame
};

/// Facets whose inscribed circle has a radius below `radius`; if `keeps_outline` is set, without
/// facets near the mesh's end. A table of `memory`. Cost: O(facets). Errors: limit, cancelled.
Result<std::vector<SmallFacet>> small_facets(Context& context, const FacetMesh& mesh,
                                             const FacetLinks& links, double radius, double margin,
                                             bool keeps_outline, TableMemory& memory);

/// The closed lines around the area of the mesh, to be filled by the even-odd rule; and whether any
/// of their edges does not lie on a side of `frame`.
struct Silhouette {
  std::vector<std::vector<Vec2>> loops;
  bool is_frame = true;
  TableMemory memory{"the outlines of facets"};
};

/// Cost: O(facets). Errors: limit, cancelled.
Result<Silhouette> silhouette(Context& context, const FacetMesh& mesh, const FacetLinks& links,
                              const Box& frame);

}  // namespace sfumato::outputs
