#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sfumato/base/image.hpp"
#include "sfumato/document/document.hpp"

/// Inputs near the limits, made from nothing.
namespace sfumato::test {

/// A straight curve with colours on both sides that change `stop_count` times.
Document curve_of_many_stops(std::size_t stop_count);

/// Short curves of two colours, scattered over an artboard of 4096.
Document many_curves(std::size_t curve_count);

/// The same as an SVG.
std::string many_curves_svg(std::size_t curve_count);

/// The same in Orzan's XML, which needs more elements for it.
std::string many_curves_orzan(std::size_t curve_count);

/// One path of that many pieces.
std::string long_path_svg(std::size_t piece_count);

/// Local curves across the artboard.
Document many_strokes(std::size_t count, float radius);

/// Noise, so that it does not compress to nothing.
Image noise_image(int width, int height, PixelFormat format = PixelFormat::rgb8);

/// A curve that is painted by a texture of this many texels on a side.
Document textured_curve(int side);

}  // namespace sfumato::test
