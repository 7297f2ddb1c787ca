#pragma once

#include "raster/kernels/image_shader_row.hpp"
#include "raster/shaders/texture_pyramid.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::raster {

/// Evaluates the texture at first + (i, 0), 0 ≤ i < count, image coordinates in pixels; sRGB code
/// values, not premultiplied.
///
/// A magnified texture is interpolated by cubic convolution (Keys 1981, a = -1/2), which passes
/// through the texels and is clamped to the range of the four around the sample. A texture minified
/// in any direction gives the mean under a tent two pixels wide, in the frame where the map is a
/// scale along two axes. All texels under the tent are summed, from a level where these are few.
void evaluate_texture(const TexturePyramid& pyramid, const Affine& layer_from_image, Vec2 first,
                      int count, const ShaderRow& row);

}  // namespace sfumato::raster
