#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/curve_edges.hpp"
#include "export/facets/facets.hpp"

/// Antialiasing of a layer's curves that have nothing on one side, for viewers that antialias only
/// paths: colours that extend beyond the curves, and a mask that ends at them.
namespace sfumato::outputs {

/// Returns whether the layer has such curves.
bool has_ends(const CurveEdges& edges);

/// The colours at these curves, in bands that extend by `width` beyond them (layer frame) and by
/// half of it under the mesh. Painted before the mesh. Errors: limit (memory), cancelled.
Result<FacetMesh> make_end_band(Context& context, const PatchLayer& layer, InterpolationSpace space,
                                const FacetSource& source, const CurveEdges& edges, double width);

/// Closed lines around the area that a layer covers, to be filled by the non-zero rule. They follow
/// the curves at which the layer ends, and run `margin` (layer frame) outside of its frame.
struct LayerOutline {
  std::vector<std::vector<Vec2>> loop;
  TableMemory memory{"outlines"};
};

/// Errors: limit (memory), cancelled.
Result<LayerOutline> outline_of_ends(Context& context, const PatchLayer& layer,
                                     const CurveEdges& edges, double margin);

}  // namespace sfumato::outputs
