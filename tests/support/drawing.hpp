#pragma once

#include <vector>

#include "sfumato/document/document.hpp"

namespace sfumato::test {

inline Curve straight_curve(Vec2 from, Vec2 to) {
  return {.control_points = {from, lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to}};
}

/// Returns a circle, clockwise on the screen (y down): its inside is on the right.
inline Curve circle_curve(Vec2 center, double radius) {
  const double k = 0.5522847498307936 * radius;
  const auto at = [&](double x, double y) { return center + Vec2{x, y}; };
  return {.control_points = {at(radius, 0), at(radius, k), at(k, radius), at(0, radius),
                             at(-k, radius), at(-radius, k), at(-radius, 0), at(-radius, -k),
                             at(-k, -radius), at(0, -radius), at(k, -radius), at(radius, -k),
                             at(radius, 0)}};
}

inline SideShader<Rgb> one_color(Rgb color) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, color}}}, 0};
}

inline Curve colored(Curve curve, Rgb left, Rgb right) {
  curve.left.color = one_color(left);
  curve.right.color = one_color(right);
  return curve;
}

inline SideShader<float> one_opacity(float opacity) {
  return {ShaderKind::curve_domain, {StopSpace::parameter, {{0, opacity}}}, 0};
}

inline Curve with_opacity(Curve curve, float left, float right) {
  curve.left.opacity = one_opacity(left);
  curve.right.opacity = one_opacity(right);
  return curve;
}

/// Returns the curve with one radius on both sides, along its whole length.
inline Curve blurred(Curve curve, float radius) {
  curve.left.blur_radius = {StopSpace::parameter, {{0, radius}}};
  curve.right.blur_radius = curve.left.blur_radius;
  return curve;
}

/// Returns a document of one layer, drawn once.
inline Document one_layer(std::vector<Curve> curves, Box artboard = {{0, 0}, {100, 100}}) {
  Document document;
  document.artboard = artboard;
  document.layers.push_back({"layer", std::move(curves)});
  document.stack.push_back(LayerInstance{});
  return document;
}

inline constexpr Rgb kRed{1, 0, 0};
inline constexpr Rgb kGreen{0, 1, 0};
inline constexpr Rgb kBlue{0, 0, 1};
inline constexpr Rgb kWhite{1, 1, 1};
inline constexpr Rgb kBlack{0, 0, 0};

}  // namespace sfumato::test
