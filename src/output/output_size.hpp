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

/// Pixels per user unit at the document's own size.
Vec2 own_scale(const Document& document);

/// Pixels per user unit of the requested size, the larger of the two directions.
double output_scale(const SizeRequest& request, const Box& viewport, Vec2 own_scale = {1, 1});

/// The size of the image that shows `viewport`, of which a window may be all that is drawn. One of
/// width and height alone sets the other by the viewport's aspect; both stretch the picture;
/// without them it is viewport × scale, by default own_scale. Sizes are rounded to the nearest
/// pixel, at least 1. Errors: limit (of the side of an image, or of one that is drawn in windows).
Result<OutputSize> output_size(const Limits& limits, const SizeRequest& request,
                               const Box& viewport, Vec2 own_scale = {1, 1},
                               bool has_window = false);

/// Makes the image what a window shows of one of this size, or all of that.
void set_size(const OutputSize& size, const std::optional<PixelRect>& window,
              RasterOptions& options);

}  // namespace sfumato::output
