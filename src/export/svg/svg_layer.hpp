#pragma once

#include <cstdint>
#include <string>

#include "export/facets/facets.hpp"
#include "export/svg/svg_mesh.hpp"

namespace sfumato::outputs {

/// A layer as a mesh for SVG, the input of append_layer.
struct SvgLayer {
  FacetMesh color;
  FacetMesh opacity;  ///< empty: opaque
  Affine layer_from_grid;
  Box box;           ///< of the facets
  Box frame;         ///< of the layer; the picture ends where the mesh ends at it
  double pixel = 1;  ///< pixel size in the smallest instance, layer frame
  UnderlapReach reach;

  std::uint64_t facet_count() const {
    return (color.facet_vertex.size() + opacity.facet_vertex.size()) / 3;
  }
};

/// Properties of a layer's instances on which its mesh depends.
struct SvgScale {
  double max_error = 0;  ///< of 1
  double pixel = 1;      ///< pixel size in a picture of nominal size, user units
  double smallest = 1;   ///< user units per unit of the layer
  double largest = 1;
};

/// Facets of a layer. Errors: limit (memory), cancelled.
Result<SvgLayer> make_svg_layer(Context& context, const PatchLayer& layer, InterpolationSpace space,
                                const SvgScale& scale);

/// <g id="ID">: the layer in its own frame (docs/outputs.md, "SVG of triangles"), after the
/// elements to which it refers. Errors: limit (memory), cancelled.
Status append_layer(Context& context, const SvgLayer& layer, const std::string& id, SvgIds& ids,
                    OutputBuffer& text);

}  // namespace sfumato::outputs
