#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/document/document.hpp"

/// Short ways to write a Document in code. Lengths in user units, y down.
namespace sfumato {

/// A colour as style sheets write it: 0xff8800 is #ff8800.
constexpr Rgb rgb(std::uint32_t hex) {
  const auto channel = [](std::uint32_t byte) { return static_cast<float>(byte & 255) / 255.0f; };
  return {channel(hex >> 16), channel(hex >> 8), channel(hex)};
}

/// A curve of cubic Béziers, without colours yet.
/// control_points    3 n + 1 for n ≥ 1 pieces, neighbours share their common point; validate()
///                   refuses other numbers
Curve bezier(std::vector<Vec2> control_points);

/// A curve of straight segments, without colours yet.
/// points    at least 2; validate() refuses fewer. Give the first point again last to close it
Curve polyline(const std::vector<Vec2>& points);

/// A side of a curve with colours at equal distances along its length: one is the same everywhere,
/// of two each has an end. No colours: the side lets rays pass.
/// blur_radius    how far from the curve the jump of colour is smoothed out; 0: sharp
Side colored(const std::vector<Rgb>& colors, float blur_radius = 0);

/// Adds a layer of curves that are solved together, painted above all that is there.
/// Returns its index in Document::layers.
std::uint32_t add_layer(Document& document, std::vector<Curve> curves, float opacity = 1,
                        BlendMode blend = BlendMode::normal);

/// Adds another instance of a layer, painted above all that is there.
void add_instance(Document& document, std::uint32_t layer, const Affine& artboard_from_layer,
                  float opacity = 1, BlendMode blend = BlendMode::normal);

}  // namespace sfumato
