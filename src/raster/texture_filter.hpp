#pragma once

#include "raster/kernels/image_shader_row.hpp"
#include "raster/texture_pyramid.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::raster {

/// The texture at first + (i, 0), 0 ≤ i < count, image coordinates in pixels; sRGB code values, not
/// premultiplied.
///
/// Magnified, by cubic convolution (Keys 1981, a = -1/2), which passes through the texels and is
/// kept from overshooting the four around the sample. Minified in any direction, the mean under a
/// tent two pixels wide, in the frame where the map is a scale along two axes: all texels under it
/// are summed, from the level where they are few.
void evaluate_texture(const TexturePyramid& pyramid, const Affine& layer_from_image, Vec2 first,
                      int count, const ShaderRow& row);

}  // namespace sfumato::raster
