#pragma once

#include <variant>

#include "raster/shaders/gradient.hpp"
#include "raster/shaders/texture_filter.hpp"
#include "raster/shaders/texture_pyramid.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::raster {

/// An image-domain shader prepared for pixels: its colour at a point is the mean over the pixel
/// around the point (docs/mathematics.md, "Image-domain shaders").
///
/// Gradients and textures are interpolated and filtered in sRGB code values, as SVG and browsers
/// do, and converted to the interpolation space afterwards.
class ImageShader {
 public:
  struct Sample {
    Rgb color;        ///< in the interpolation space, not premultiplied
    float alpha = 1;  ///< 0 to 1
  };

  /// Prepares a shader. Precondition: its document was validated. No reference to `shader` is kept.
  /// Errors: limit (memory), cancelled. Cost: O(texels) or O(stops).
  static Result<ImageShader> create(Context& context, const Shader& shader,
                                    InterpolationSpace space);

  /// Computes colours at the pixel centres (x0 + i + 1/2, y + 1/2), 0 ≤ i < count, of an image row,
  /// in the interpolation space, not premultiplied; 0 where alpha is 0.
  ///
  /// layer_from_image  invertible; image coordinates are pixels. One instance of the layer.
  ///
  /// Thread-safe; the value at a pixel does not depend on how rows are cut.
  void evaluate(const Affine& layer_from_image, double x0, double y, int count, float* r, float* g,
                float* b, float* alpha) const;

  /// Does the same for the pixel-sized square around one point.
  Sample at(const Affine& layer_from_image, Vec2 image_point) const;

 private:
  using Paint = std::variant<Gradient, TexturePyramid>;

  ImageShader(Paint paint, InterpolationSpace space) : paint_(std::move(paint)), space_(space) {}

  /// Evaluates from sample point (x, y) on, in steps of one pixel.
  void evaluate_row(const Affine& layer_from_image, Vec2 first, int count,
                    const ShaderRow& row) const;

  Paint paint_;
  InterpolationSpace space_;
};

}  // namespace sfumato::raster
