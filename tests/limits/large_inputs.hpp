#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"

/// Generated inputs near the limits.
namespace sfumato::test {

/// Returns a straight curve with colours on both sides that change `stop_count` times.
Document curve_of_many_stops(std::size_t stop_count);

/// Returns short curves of two colours, scattered over an artboard of 4096.
Document many_curves(std::size_t curve_count);

/// The same as an SVG.
std::string many_curves_svg(std::size_t curve_count);

/// The same in Orzan's XML, which needs more elements for it.
std::string many_curves_orzan(std::size_t curve_count);

/// Returns one path of that many pieces.
std::string long_path_svg(std::size_t piece_count);

enum class ShapePlaces : std::uint8_t { apart, on_ground, overlapping };
const char* name_of(ShapePlaces places);

/// Returns an ordinary SVG of circles: apart from each other, the same on an opaque ground, or each
/// over some others.
std::string many_shapes_svg(int count, ShapePlaces places);

/// Returns local curves across the artboard.
Document many_strokes(std::size_t count, float radius);

/// Returns noise, which hardly compresses.
Image noise_image(int width, int height, PixelFormat format = PixelFormat::rgb8);

/// Returns a curve painted by a texture of this many texels per side.
Document textured_curve(int side);

}  // namespace sfumato::test
