#include "raster/shader_set.hpp"

#include <utility>

namespace sfumato::raster {
namespace {

/// Makes the shaders of `used` that are not there yet.
Status make_shaders(Context& context, const Picture& picture,
                    const std::vector<std::uint32_t>& used, InterpolationSpace space,
                    std::vector<std::optional<ImageShader>>* shaders) {
  for (std::uint32_t index : used) {
    std::optional<ImageShader>& slot = (*shaders)[index];
    if (slot) continue;
    Result<ImageShader> shader = ImageShader::create(context, picture.shaders[index], space);
    if (!shader) return shader.status();
    slot.emplace(std::move(*shader));
  }
  return ok_status();
}

}  // namespace

Result<ShaderSet> ShaderSet::create(Context& context, const Picture& picture) {
  ShaderSet set;
  for (auto* shaders : {&set.color_, &set.opacity_}) {
    Status status = set.memory_.reserve(context, *shaders, picture.shaders.size());
    if (!status) return status;
    shaders->resize(picture.shaders.size());
  }
  for (const PatchLayer& layer : picture.layers) {
    Status status =
        make_shaders(context, picture, layer.color.shader, picture.interpolation, &set.color_);
    if (!status) return status;
    status = make_shaders(context, picture, layer.opacity.shader, InterpolationSpace::srgb,
                          &set.opacity_);
    if (!status) return status;
  }
  return set;
}

}  // namespace sfumato::raster
