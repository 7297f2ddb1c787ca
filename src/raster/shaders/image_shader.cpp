#include "raster/shaders/image_shader.hpp"

#include <utility>

#include "base/try.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::raster {
Result<ImageShader> ImageShader::create(Context& context, const Shader& shader,
                                        InterpolationSpace space) {
  if (const auto* fill = std::get_if<GradientFill>(&shader.paint)) {
    SFUMATO_TRY_ASSIGN(auto&& gradient, Gradient::create(context, *fill));
    return ImageShader(std::move(gradient), space);
  }
  SFUMATO_TRY_ASSIGN(auto&& pyramid,
                     TexturePyramid::create(context, std::get<Texture>(shader.paint)));
  return ImageShader(std::move(pyramid), space);
}

void ImageShader::evaluate_row(const Affine& layer_from_image, Vec2 first, int count,
                               const ShaderRow& row) const {
  if (const auto* gradient = std::get_if<Gradient>(&paint_))
    gradient->evaluate(layer_from_image, first, count, row);
  else
    evaluate_texture(std::get<TexturePyramid>(paint_), layer_from_image, first, count, row);
  if (space_ == InterpolationSpace::srgb) return;
  for (int i = 0; i < count; ++i) {
    const Rgb color = from_srgb(space_, {row.r[i], row.g[i], row.b[i]});
    row.r[i] = color.r;
    row.g[i] = color.g;
    row.b[i] = color.b;
  }
}

void ImageShader::evaluate(const Affine& layer_from_image, double x0, double y, int count, float* r,
                           float* g, float* b, float* alpha) const {
  evaluate_row(layer_from_image, {x0 + 0.5, y + 0.5}, count, {r, g, b, alpha});
}

ImageShader::Sample ImageShader::at(const Affine& layer_from_image, Vec2 image_point) const {
  Sample sample;
  evaluate_row(layer_from_image, image_point, 1,
               {&sample.color.r, &sample.color.g, &sample.color.b, &sample.alpha});
  return sample;
}

}  // namespace sfumato::raster
