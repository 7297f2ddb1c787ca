#include "raster/shaders/point_shader.hpp"

namespace sfumato::raster {

bool has_weight(const FieldView& field, int first_channel, std::uint32_t triangle) {
  const WeightChannels channels(field, first_channel);
  for (std::size_t i = 0; i < kNodesPerTriangle; ++i)
    if (any(abs(channels.at(node_slot(triangle, i))) > Color4(0))) return true;
  return false;
}

void PointShader::add_weights(const FieldView& field, std::uint32_t triangle,
                              const TriangleFrame& frame) {
  for (int first = field.first_weight(); first < field.channel_count; first += 4) {
    if (!has_weight(field, first, triangle)) continue;
    const WeightChannels channels(field, first);
    weights_.push_back({patch_polynomial(channels, layer_.order, triangle, frame), &field, first});
  }
}

void PointShader::begin_triangle(std::uint32_t triangle, const TriangleFrame& frame) {
  patch_ = layer_.opacity.channel_count > 0
               ? patch_polynomial(ColorOpacityChannels(layer_), layer_.order, triangle, frame)
               : patch_polynomial(ColorChannels(layer_), layer_.order, triangle, frame);
  weights_.clear();
  add_weights(layer_.color, triangle, frame);
  add_weights(layer_.opacity, triangle, frame);
}

void PointShader::add_shader(const FieldView& field, int channel, float weight, Vec2 pixel_center,
                             float (&value)[4]) const {
  const std::uint32_t index = field.shader[channel - field.first_weight()];
  if (field.is_opacity()) {
    const ImageShader::Sample sample =
        input_.shaders->of_opacity(index).at(input_.layer_from_image, pixel_center);
    value[3] += weight * opacity_of(sample.color.r, sample.color.g, sample.color.b, sample.alpha);
    return;
  }
  const ImageShader::Sample sample =
      input_.shaders->of_color(index).at(input_.layer_from_image, pixel_center);
  value[0] += weight * sample.color.r;
  value[1] += weight * sample.color.g;
  value[2] += weight * sample.color.b;
}

/// Adds a field's shaders by their weights in the last of its channels.
void PointShader::add_shaders(const FieldView& field, const float* value, Vec2 pixel_center,
                              float (&sum)[4]) const {
  for (int channel = field.first_weight(); channel < field.channel_count; ++channel)
    if (value[channel] != 0) add_shader(field, channel, value[channel], pixel_center, sum);
}

Color4 PointShader::exact_value(const float* color, const float* opacity, Vec2 pixel_center) const {
  float sum[4] = {color[0], color[1], color[2], opacity ? opacity[0] : 1};
  add_shaders(layer_.color, color, pixel_center, sum);
  if (opacity) add_shaders(layer_.opacity, opacity, pixel_center, sum);
  return Color4::load(sum);
}

Color4 PointShader::at_center(std::uint32_t triangle) const {
  const std::size_t slot = node_slot(triangle, kCenterNode);
  if (layer_.opacity.channel_count > 0) return shown(ColorOpacityChannels(layer_).at(slot));
  return shown(ColorChannels(layer_).at(slot) + color4(0, 0, 0, 1));
}

Color4 PointShader::with_shaders(const Color4& patch, const PatchPoint& point,
                                 Vec2 pixel_center) const {
  float value[4];
  patch.store(value);
  for (const WeightPatch& weights : weights_) {
    float weight[4];
    patch_color(weights.patch, point).store(weight);
    for (int i = 0; i < 4 && weights.first_channel + i < weights.field->channel_count; ++i) {
      if (weight[i] == 0) continue;
      add_shader(*weights.field, weights.first_channel + i, weight[i], pixel_center, value);
    }
  }
  return Color4::load(value);
}

Color4 PointShader::shown_from(const Color4& value) const {
  const Rgb3<1> code =
      clamped_srgb<1>(input_.space, {Lanes<1>(value[0]), Lanes<1>(value[1]), Lanes<1>(value[2])});
  return premultiplied(color4(code.r[0], code.g[0], code.b[0], clamped_unit(value)[3]));
}

}  // namespace sfumato::raster
