#include "sfumato/document/document.hpp"

namespace sfumato {
namespace {

template <class Value>
std::size_t bytes_of(const StopList<Value>& list) {
  return list.stops.capacity() * sizeof(Stop<Value>);
}

std::size_t bytes_of(const Side& side) {
  return bytes_of(side.color.stops) + bytes_of(side.opacity.stops) + bytes_of(side.blur_radius);
}

std::size_t bytes_of(const GradientFill& fill) {
  return fill.stops.capacity() * sizeof(GradientStop);
}

std::size_t bytes_of(const Texture& texture) {
  return texture.rgba.capacity() + texture.file.capacity();
}

}  // namespace

std::size_t bytes_of(const Curve& curve) {
  return curve.control_points.capacity() * sizeof(Vec2) + bytes_of(curve.left) +
         bytes_of(curve.right);
}

std::size_t bytes_of(const LocalCurve& curve) {
  return curve.control_points.capacity() * sizeof(Vec2) + bytes_of(curve.left_color) +
         bytes_of(curve.right_color) + bytes_of(curve.blur_radius) +
         bytes_of(curve.influence_radius);
}

std::size_t bytes_of(const std::vector<Shader>& shaders) {
  std::size_t bytes = shaders.capacity() * sizeof(Shader);
  for (const Shader& shader : shaders) {
    bytes += std::visit([](const auto& paint) { return bytes_of(paint); }, shader.paint);
  }
  return bytes;
}

std::size_t bytes_of(const std::vector<StackItem>& stack) {
  std::size_t bytes = stack.capacity() * sizeof(StackItem);
  for (const StackItem& item : stack) {
    if (const auto* stroke = std::get_if<LocalStroke>(&item)) bytes += bytes_of(stroke->curve);
  }
  return bytes;
}

std::size_t bytes_of(const Document& document) {
  std::size_t bytes = bytes_of(document.shaders) + bytes_of(document.stack);
  for (const Layer& layer : document.layers) {
    bytes += layer.curves.capacity() * sizeof(Curve);
    for (const Curve& curve : layer.curves) bytes += bytes_of(curve);
  }
  return bytes;
}

}  // namespace sfumato
