#pragma once

#include <span>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

/// Parts of a picture that vector formats store as pixels, painted by the rasterizer.
namespace sfumato::outputs {

struct PixelPart {
  Box box;  ///< filled by the image; empty: nothing is visible
  Image image;
  ScopedCharge charge;  ///< for the image
};

/// Most pixels of one part; a part that would have more gets fewer pixels per unit.
inline constexpr double kMostPartPixels = 40e6;

/// Returns the colours of an image-domain shader over a box of the layer frame, rgb8, or its
/// contribution to opacity, in the alpha of rgba8. Colours in sRGB code values. Errors: limit
/// (memory), cancelled.
Result<PixelPart> shader_pixels(Context& context, const Shader& shader, bool as_opacity,
                                const Box& box, double pixels_per_unit);

/// Returns the mean of a part's colours. Error: cancelled.
Result<Rgb> mean_color(const Context& context, const PixelPart& part);

/// Returns the mean of the alpha of an rgba8 part, as grey. Error: cancelled.
Result<Rgb> mean_opacity(const Context& context, const PixelPart& part);

/// Returns a whole layer in its own frame, rgba8. Errors: limit (memory), cancelled.
Result<PixelPart> layer_pixels(Context& context, const Picture& picture, std::uint32_t layer,
                               const Box& box, double pixels_per_unit);

/// Returns all of a picture's viewport on its background or white, rgb8. Errors: limit (memory),
/// cancelled.
Result<PixelPart> picture_pixels(Context& context, const Picture& picture, double pixels_per_unit);

/// Local curves painted one over the other, rgba8, in as much of `viewport` as they need. Artboard
/// frame. Transparent pixels next to them have their colour, so that viewers that filter the image
/// show no fringe. Errors: limit (memory), cancelled.
Result<PixelPart> stroke_pixels(Context& context, std::span<const PictureItem> strokes,
                                InterpolationSpace space, const Box& viewport,
                                double pixels_per_unit);

/// Gives transparent pixels of an rgba8 image the mean colour of their neighbours that are not
/// transparent, so that programs that filter the image show no fringe. Error: cancelled.
Status bleed(const Context& context, Image* image);

}  // namespace sfumato::outputs
