#pragma once

#include <cstdint>
#include <vector>

#include "base/affine.hpp"
#include "base/context.hpp"
#include "base/status.hpp"
#include "patches/picture.hpp"

namespace sfumato::outputs {

/// The gradients and textures of a picture as the shaders of web/viewer/shaders read them
/// (docs/gpu.md, "The table of paints").
struct PaintTable {
  std::vector<float> values;               ///< four to a texel of `paint_table`
  std::vector<std::uint16_t> texels;       ///< four to a texel of `paint_texels`
  std::vector<std::uint32_t> first_value;  ///< per shader of the picture: its first texel
  std::vector<Affine> paint_from_layer;    ///< per shader
  ScopedCharge charge;
};

/// Takes the shaders that a layer names; others have no values.
///
/// Precondition: the picture's tables fit (raster::check_picture).
/// Errors: limit (memory), cancelled. Cost: O(stops + texels).
Result<PaintTable> make_paint_table(Context& context, const Picture& picture);

}  // namespace sfumato::outputs
