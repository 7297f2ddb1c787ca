#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/document/document.hpp"

/// @file
/// Short ways to write a Document in code. Lengths are in user units, and y points down.

namespace sfumato {

/// Returns a colour as in style sheets: 0xff8800 is `#ff8800`.
constexpr Rgb rgb(std::uint32_t hex) {
  const auto channel = [](std::uint32_t byte) { return static_cast<float>(byte & 255) / 255.0f; };
  return {channel(hex >> 16), channel(hex >> 8), channel(hex)};
}

/// Makes a curve of cubic Béziers, without colours yet.
///
/// `control_points` are 3 n + 1 for n pieces, n at least 1: neighbouring pieces share a point.
/// validate() refuses other numbers.
Curve bezier(std::vector<Vec2> control_points);

/// Makes a curve of straight segments, one Bézier piece each, without colours yet.
///
/// `points` are at least 2: validate() refuses fewer. To close the curve, end with the first point.
Curve polyline(const std::vector<Vec2>& points);

/// Makes a side of a curve with colours at equal distances along its length.
///
/// One colour holds along the whole curve. With several, the first is at the start of the curve and
/// the last at its end. Without any, the side lets rays pass. `blur_radius` is the distance from
/// the curve over which the jump between its two sides is smoothed; 0 leaves it sharp.
Side colored(const std::vector<Rgb>& colors, float blur_radius = 0);

/// Adds a layer of curves that are solved together, and paints it above everything else. Returns
/// its index in Document::layers.
std::uint32_t add_layer(Document& document, std::vector<Curve> curves, float opacity = 1,
                        BlendMode blend = BlendMode::normal);

/// Paints a layer once more, above everything else. `layer` is an index into Document::layers.
void add_instance(Document& document, std::uint32_t layer, const Affine& artboard_from_layer,
                  float opacity = 1, BlendMode blend = BlendMode::normal);

}  // namespace sfumato
