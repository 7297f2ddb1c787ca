#include "sfumato/api/draw_document.hpp"

#include <algorithm>

#include "base/try.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

Result<Image> draw_document(Context& context, const Document& document, int width, int height) {
  const Box& artboard = document.artboard;
  DiffuseOptions options;
  options.pixels_per_unit = std::max(width / artboard.width(), height / artboard.height());
  SFUMATO_TRY_ASSIGN(const Picture& picture, diffuse(context, document, options));
  RasterOptions pixels;
  pixels.width = width;
  pixels.height = height;
  pixels.format = PixelFormat::rgba8;
  return rasterize(context, picture, pixels);
}

}  // namespace sfumato
