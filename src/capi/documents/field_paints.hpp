#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/shaders/image_shader.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::capi {

/// Evaluates the gradients and textures that one field of a layer mixes, at single points.
class FieldPaints {
 public:
  FieldPaints() = default;

  /// shaders  indices into `all`, in the order of their channels
  /// space    in which the field mixes colours; code values for opacities
  /// pixel    what a texture is averaged over, layer units
  /// Errors   limit (memory), cancelled. The object keeps nothing of `all`.
  static Result<FieldPaints> create(Context& context, const std::vector<Shader>& all,
                                    std::span<const std::uint32_t> shaders,
                                    InterpolationSpace space, double pixel);

  std::size_t count() const { return shaders_.size(); }

  /// Returns the sum that the paints add to a colour at a point of the layer: each paint's colour
  /// times its weight.
  Rgb color_at(Vec2 point, const float* weight) const;
  /// Returns the sum that the paints add to an opacity: alpha times luminance.
  float opacity_at(Vec2 point, const float* weight) const;

 private:
  template <class Visit>
  void for_each_sample(Vec2 point, const float* weight, Visit visit) const;

  std::vector<raster::ImageShader> shaders_;
  double pixel_ = 1;
  TableMemory memory_{"shaders"};  ///< of the list
};

}  // namespace sfumato::capi
