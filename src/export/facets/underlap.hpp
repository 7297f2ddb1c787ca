#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/facet_links.hpp"

namespace sfumato::outputs {

/// How far facets are to reach under their neighbours and beyond the mesh, layer frame.
struct UnderlapReach {
  double inside = 0;
  double outside = 0;  ///< 0: the mesh ends where it ends
};

/// Outlines of facets that can be painted one after another, each antialiased, with no seams
/// between them: a facet reaches under those that are painted later, and the first at a corner
/// under all around it. What shows in the end is the facets alone.
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

/// A facet too small for that: where it and its neighbours share pixels, what lies below shows
/// through. Made larger by `margin` on all sides it is what to paint there first.
struct SmallFacet {
  std::uint32_t facet = 0;
  std::array<Vec2, 3> grown;  ///< layer frame
};

/// Facets whose inscribed circle has a radius below `radius`; not those near the mesh's end where
/// `keeps_outline` is set; a table of `memory`. Cost: O(facets). Errors: limit, cancelled.
Result<std::vector<SmallFacet>> small_facets(Context& context, const FacetMesh& mesh,
                                             const FacetLinks& links, double radius, double margin,
                                             bool keeps_outline, TableMemory& memory);

/// The closed lines around what the mesh covers, for filling by the even-odd rule; whether there is
/// any of which not both ends lie on one side of `frame`.
struct Silhouette {
  std::vector<std::vector<Vec2>> loops;
  bool is_frame = true;
  TableMemory memory{"the outlines of facets"};
};

/// Cost: O(facets). Errors: limit, cancelled.
Result<Silhouette> silhouette(Context& context, const FacetMesh& mesh, const FacetLinks& links,
                              const Box& frame);

}  // namespace sfumato::outputs
