#include "capi/documents/field_paints.hpp"

#include <utility>

#include "base/try.hpp"
#include "raster/shaders/shader_set.hpp"

namespace sfumato::capi {

Result<FieldPaints> FieldPaints::create(Context& context, const std::vector<Shader>& all,
                                        std::span<const std::uint32_t> shaders,
                                        InterpolationSpace space, double pixel) {
  FieldPaints paints;
  paints.pixel_ = pixel;
  SFUMATO_TRY(paints.memory_.reserve(context, paints.shaders_, shaders.size()));
  for (const std::uint32_t shader : shaders) {
    SFUMATO_TRY_ASSIGN(auto&& made, raster::ImageShader::create(context, all[shader], space));
    paints.shaders_.push_back(std::move(made));
  }
  return paints;
}

/// Calls visit(sample, weight) for the paints that show.
template <class Visit>
void FieldPaints::for_each_sample(Vec2 point, const float* weight, Visit visit) const {
  const Affine layer_from_image{pixel_, 0, 0, pixel_, 0, 0};
  for (std::size_t i = 0; i < shaders_.size(); ++i) {
    if (weight[i] != 0) visit(shaders_[i].at(layer_from_image, point / pixel_), weight[i]);
  }
}

Rgb FieldPaints::color_at(Vec2 point, const float* weight) const {
  Rgb sum{0, 0, 0};
  for_each_sample(point, weight, [&](const raster::ImageShader::Sample& sample, float w) {
    sum.r += w * sample.color.r;
    sum.g += w * sample.color.g;
    sum.b += w * sample.color.b;
  });
  return sum;
}

float FieldPaints::opacity_at(Vec2 point, const float* weight) const {
  float sum = 0;
  for_each_sample(point, weight, [&](const raster::ImageShader::Sample& sample, float w) {
    const Rgb& c = sample.color;
    sum += w * raster::opacity_of(c.r, c.g, c.b, sample.alpha);
  });
  return sum;
}

}  // namespace sfumato::capi
