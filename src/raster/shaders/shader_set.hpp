#pragma once

#include <optional>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/shaders/image_shader.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::raster {

/// The image-domain shaders of a picture, made once and read by every thread.
class ShaderSet {
 public:
  /// Prepares the shaders that a layer names. Errors: limit, cancelled.
  static Result<ShaderSet> create(Context& context, const Picture& picture);

  /// Returns a shader that a layer's colour names, in the picture's interpolation space.
  const ImageShader& of_color(std::uint32_t shader) const { return *color_[shader]; }
  /// Returns a shader that a layer's opacity names, in code values.
  const ImageShader& of_opacity(std::uint32_t shader) const { return *opacity_[shader]; }

 private:
  std::vector<std::optional<ImageShader>> color_, opacity_;
  TableMemory memory_{"shaders"};
};

/// Returns the opacity that a shader gives: alpha times the luminance of its code values, as
/// browsers compute it for SVG masks.
inline float opacity_of(float r, float g, float b, float alpha) {
  return alpha * (0.2126f * r + 0.7152f * g + 0.0722f * b);
}

}  // namespace sfumato::raster
