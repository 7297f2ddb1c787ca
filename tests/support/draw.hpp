#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::test {

/// Draws a document as `sfumato render` does, without dither. Returns the errors of diffuse() and
/// rasterize().
inline Result<Image> draw(Context& context, const Document& document, int width, int height,
                          PixelFormat format) {
  DiffuseOptions options;
  options.pixels_per_unit = width / document.artboard.width();
  const Result<Picture> picture = diffuse(context, document, options);
  if (!picture) return picture.status();
  RasterOptions raster;
  raster.width = width;
  raster.height = height;
  raster.format = format;
  return rasterize(context, *picture, raster);
}

}  // namespace sfumato::test
