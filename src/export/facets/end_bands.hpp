#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "export/facets/curve_edges.hpp"
#include "export/facets/facets.hpp"

/// What antialiases the curves of a layer that have nothing on one side, in viewers that antialias
/// paths alone: colours that go on beyond them, and a mask that ends there.
namespace sfumato::outputs {

/// Whether the layer has such curves.
bool has_ends(const CurveEdges& edges);

/// The colours at these curves, `width` wide beyond them (layer frame) and half as wide under the
/// mesh: what to paint before it. Errors: limit (memory), cancelled.
Result<FacetMesh> make_end_band(Context& context, const PatchLayer& layer, InterpolationSpace space,
                                const FacetSource& source, const CurveEdges& edges, double width);

/// Closed lines, to be filled by the non-zero rule, around what a layer covers: they follow the
/// curves where it ends, and stay `margin` (layer frame) outside of its frame.
struct LayerOutline {
  std::vector<std::vector<Vec2>> loop;
  TableMemory memory{"outlines"};
};

/// Errors: limit (memory), cancelled.
Result<LayerOutline> outline_of_ends(Context& context, const PatchLayer& layer,
                                     const CurveEdges& edges, double margin);

}  // namespace sfumato::outputs
