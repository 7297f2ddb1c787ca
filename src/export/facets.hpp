#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "patches/picture.hpp"

namespace sfumato::outputs {

/// What a facet mesh carries: the colour of a layer in sRGB code values (3 channels), its opacity
/// (1 channel), or the weights of one of the shaders of either field (1 channel).
struct FacetSource {
  enum class Kind : std::uint8_t { color, opacity, color_weight, opacity_weight };
  Kind kind = Kind::color;
  std::uint32_t shader = 0;  ///< of a weight: index into PatchField::shader
};

/// Triangles with linear interpolation (Gouraud) that show a field of a layer within a bounded
/// error. Facets of one patch are consecutive and patches keep their order.
struct FacetMesh {
  int channel_count = 3;
  std::vector<Vec2> vertex_position;             ///< layer frame
  std::vector<float> vertex_value;               ///< channel_count per vertex, 0 to 1
  std::vector<std::uint32_t> facet_vertex;       ///< 3 per facet, cross(01, 02) > 0
  std::vector<std::uint32_t> patch_first_facet;  ///< triangle_count + 1
};

/// Layer → facets. A patch is cut into n² facets, n by the bound on its second differences
/// (docs/mathematics.md, "Facets"); an edge that two patches share gets the finer of their cuts, so
/// that there are no T-junctions, and both have the same bits along it.
///
/// max_error  largest tolerated difference to the patch, of 1; values are clamped to [0, 1] first.
/// Colours of linear and OKLab pictures are converted to code values, and the bound holds there.
/// Errors: limit (memory), cancelled.
Result<FacetMesh> make_facets(Context& context, const PatchLayer& layer, InterpolationSpace space,
                              const FacetSource& source, double max_error);

}  // namespace sfumato::outputs
