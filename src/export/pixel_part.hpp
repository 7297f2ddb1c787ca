#pragma once

#include <span>

#include "base/charge.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

/// What vector formats hold as pixels: parts of a picture, painted by the rasterizer.
namespace sfumato::outputs {

struct PixelPart {
  Box box;  ///< that the image fills; empty where there is nothing
  Image image;
  ScopedCharge charge;  ///< of the image
};

/// Most pixels of one part; above, it gets fewer to a unit.
inline constexpr double kMostPartPixels = 64e6;

/// The colours of an image-domain shader over a box of the layer frame, rgb8, or what it adds to
/// opacity, in the alpha of rgba8. Colours in sRGB code values.
/// Errors: limit (memory), cancelled.
Result<PixelPart> shader_pixels(Context& context, const Shader& shader, bool as_opacity,
                                const Box& box, double pixels_per_unit);

/// The mean of a part's colours. Error: cancelled.
Result<Rgb> mean_color(const Context& context, const PixelPart& part);

/// The mean of the alpha of an rgba8 part, as grey. Error: cancelled.
Result<Rgb> mean_opacity(const Context& context, const PixelPart& part);

/// A whole layer in its own frame, rgba8. Errors: limit (memory), cancelled.
Result<PixelPart> layer_pixels(Context& context, const Picture& picture, std::uint32_t layer,
                               const Box& box, double pixels_per_unit);

/// All of a picture's viewport on its background or white, rgb8. Errors: limit (memory), cancelled.
Result<PixelPart> picture_pixels(Context& context, const Picture& picture, double pixels_per_unit);

/// Items that are local curves, one painted over the other, rgba8, in as much of `viewport` as they
/// need. Artboard frame. Pixels next to them that are transparent have their colour, so that
/// viewers which filter leave no fringe. Errors: limit (memory), cancelled.
Result<PixelPart> stroke_pixels(Context& context, std::span<const PictureItem> strokes,
                                InterpolationSpace space, const Box& viewport,
                                double pixels_per_unit);

/// Gives transparent pixels of an rgba8 image the mean colour of neighbours that are not, so that
/// programs which filter it leave no fringe. Error: cancelled.
Status bleed(const Context& context, Image* image);

}  // namespace sfumato::outputs
