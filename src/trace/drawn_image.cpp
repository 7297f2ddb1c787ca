#include "trace/drawn_image.hpp"

#include <algorithm>

#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::tracing {

Result<Image> drawn_image(Context& context, const Document& drawing, int width, int height,
                          double max_error) {
  DiffuseOptions diffuse_options;
  diffuse_options.pixels_per_unit =
      std::max(width / drawing.artboard.width(), height / drawing.artboard.height());
  diffuse_options.max_error = max_error;
  const Result<sfumato::Picture> solved = diffuse(context, drawing, diffuse_options);
  if (!solved) return solved.status();
  RasterOptions options;
  options.width = width;
  options.height = height;
  options.format = PixelFormat::rgba16;
  return rasterize(context, *solved, options);
}

}  // namespace sfumato::tracing
