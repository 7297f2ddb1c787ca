#pragma once

#include <optional>

#include "base/pixel_rect.hpp"
#include "options/settings.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::output {

using options::SizeRequest;

struct OutputSize {
  int width = 0;
  int height = 0;
  double pixels_per_unit = 1;  ///< the larger of the two directions
};

/// Returns the pixels per user unit at the document's own size.
Vec2 own_scale(const Document& document);

/// Returns the pixels per user unit of the requested size, the larger of the two directions.
double output_scale(const SizeRequest& request, const Box& viewport, Vec2 own_scale = {1, 1});

/// Returns the size of the image that shows `viewport`; the caller may draw only a window of it.
/// Width or height alone sets the other by the viewport's aspect. Both stretch the picture. Without
/// them the size is viewport × scale, by default own_scale. Sizes are rounded to the nearest pixel,
/// at least 1. Errors: limit (of the side of an image, or of an image that is drawn in windows).
Result<OutputSize> output_size(const Limits& limits, const SizeRequest& request,
                               const Box& viewport, Vec2 own_scale = {1, 1},
                               bool has_window = false);

/// Sets the image to the part of an image of this size that the window shows, or to the whole image
/// without a window.
void set_size(const OutputSize& size, const std::optional<PixelRect>& window,
              RasterOptions& options);

}  // namespace sfumato::output
