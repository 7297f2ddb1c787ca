#pragma once

#include "raster/layers/exact_points.hpp"
#include "raster/shaders/point_shader.hpp"

namespace sfumato::raster {

/// Shades the parts of pixels by a layer's exact fields.
class ExactShader {
 public:
  /// Makes a shader. All arguments must outlive it. shading: null for a layer that is painted
  /// straight.
  ExactShader(const LayerView& layer, const ExactPoints& points, const PointShader* shading)
      : layer_(layer), points_(points), shading_(shading) {}

  const LayerView& layer() const { return layer_; }

  /// Returns the colour in the interpolation space and the opacity, for mixing by a blur.
  Color4 value(std::uint32_t point, Vec2 pixel_center) const {
    const float* color = points_.color(point);
    if (!shading_) return color4(color[0], color[1], color[2], 1);
    if (!points_.is_hit(point)) return Color4(0);
    return shading_->exact_value(color, points_.opacity(point), pixel_center);
  }
  Color4 shown(const Color4& value) const { return shading_ ? shading_->shown(value) : value; }

 private:
  const LayerView& layer_;
  const ExactPoints& points_;
  const PointShader* shading_;
};

}  // namespace sfumato::raster
