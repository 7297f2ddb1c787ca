#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The values of a facet mesh: the colour of a layer in sRGB code values (3 channels) or its
/// opacity (1 channel), both without the contribution of shaders.
///
/// `light` is for programs that interpolate linear light: colour and opacity at once (4 channels;
/// the layer's colour field must have no others), cut so that their error, in code values too, is
/// bounded.
///
/// For composition by source-over (docs/pdf.md): `base` is the curves' contribution divided by
/// their share, and `mask` the weight of a shader divided by the share that the shaders after it
/// leave.
struct FacetSource {
  enum class Kind : std::uint8_t {
    color,
    opacity,
    light,
    color_base,
    opacity_base,
    color_mask,
    opacity_mask
  };
  Kind kind = Kind::color;
  std::uint32_t shader = 0;  ///< of a mask: index into PatchField::shader
  /// For a base: the approximate colour of each of the field's shaders, code values. Where a shader
  /// has the whole share, this colour is painted below it, in case it leaves a gap. Empty, or one
  /// per shader.
  std::vector<Rgb> shown{};
};

/// Triangles with linear interpolation (Gouraud) that show a field of a layer within a bounded
/// error. Facets of one patch are consecutive and patches keep their order.
struct FacetMesh {
  int channel_count = 3;
  std::vector<Vec2> vertex_position;             ///< layer frame
  std::vector<float> vertex_value;               ///< channel_count per vertex, 0 to 1
  std::vector<std::uint32_t> facet_vertex;       ///< 3 per facet, cross(01, 02) > 0
  std::vector<std::uint32_t> patch_first_facet;  ///< triangle_count + 1
  TableMemory memory{"facets"};

  /// Reserves room for more vertices and facets.
  Status make_room(Context& context, std::size_t vertices, std::size_t facets) {
    const auto channels = static_cast<std::size_t>(channel_count);
    Status status = memory.make_room(context, vertex_position, vertices);
    if (status) status = memory.make_room(context, vertex_value, channels * vertices);
    return status ? memory.make_room(context, facet_vertex, 3 * facets) : status;
  }

  /// value   channel_count of them are read
  std::uint32_t add_vertex(Vec2 at, std::span<const double> value) {
    vertex_position.push_back(at);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channel_count); ++c)
      vertex_value.push_back(static_cast<float>(value[c]));
    return static_cast<std::uint32_t>(vertex_position.size() - 1);
  }
};

/// Layer → facets. Sides that bend are halved until they are straight enough (docs/mathematics.md,
/// "Facets"). Neighbours cut their common edge in the same places, so that there are no
/// T-junctions. If they share its nodes they share its vertices too; otherwise positions have the
/// same bits.
///
/// layer, source  of a picture that check_picture() accepts; the field has channels
/// max_error      above 0: largest difference to the patch, values of both cut to [0, 1]. Colours
///                of linear and OKLab pictures are converted to code values, and the bound holds
///                there. A patch that needs more than 64 cuts exceeds it. Errors of base and mask
///                are weighted with the share that shows them.
/// smallest_side  patches are not cut into shorter sides, layer frame; it takes precedence over
///                max_error
/// Errors: limit (memory), cancelled. Cost: about 1 µs a facet on one thread; the same bytes for
/// any thread count.
Result<FacetMesh> make_facets(Context& context, const PatchLayer& layer, InterpolationSpace space,
                              const FacetSource& source, double max_error,
                              double smallest_side = 0);

}  // namespace sfumato::outputs
