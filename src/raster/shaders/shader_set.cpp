#include "raster/shaders/shader_set.hpp"

#include <utility>

#include "base/try.hpp"

namespace sfumato::raster {
namespace {

/// Makes the shaders of `used` that do not exist yet.
Status make_shaders(Context& context, const Picture& picture,
                    const std::vector<std::uint32_t>& used, InterpolationSpace space,
                    std::vector<std::optional<ImageShader>>* shaders) {
  for (std::uint32_t index : used) {
    std::optional<ImageShader>& slot = (*shaders)[index];
    if (slot) continue;
    SFUMATO_TRY_ASSIGN(auto&& shader, ImageShader::create(context, picture.shaders[index], space));
    slot.emplace(std::move(shader));
  }
  return ok_status();
}

}  // namespace

Result<ShaderSet> ShaderSet::create(Context& context, const Picture& picture) {
  ShaderSet set;
  for (auto* shaders : {&set.color_, &set.opacity_}) {
    SFUMATO_TRY(set.memory_.reserve(context, *shaders, picture.shaders.size()));
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
