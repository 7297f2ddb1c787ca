#include "capi/picture.hpp"
#include "capi/pixels.hpp"
#include "capi/read_options.hpp"
#include "options/tables.hpp"
#include "raster/rasterize_into.hpp"

namespace sfumato::capi {
namespace {

Outcome draw(Workshop& workshop, const sfumato_picture* handle, const sfumato_image* image,
             const char* text) {
  if (!handle) return bad_usage("NULL given, expected a picture");
  const std::optional<PixelFormat> format = format_of(image);
  if (!format) return bad_usage(kNoImage);
  options::Settings settings;
  if (Outcome read = read_options(text, options::kRaster, options::render_options(), settings);
      read.code != SFUMATO_OK)
    return read;
  RasterOptions& options = settings.raster;
  options.width = image->width;
  options.height = image->height;
  options.format = *format;
  options.viewport = settings.diffuse.viewport;
  options.dither = settings.dither.value_or(false);
  const Picture& picture = handle->solution.picture();
  const std::optional<Rgb> own = settings.no_background ? std::nullopt : picture.background;
  return raster::rasterize_into_on(workshop.context, picture, options, own,
                                   static_cast<std::uint8_t*>(image->pixels), image->row_bytes);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_raster(sfumato_context* context, const sfumato_picture* picture,
                       const sfumato_image* image, const char* options) {
  return sfumato::capi::call(context, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::draw(workshop, picture, image, options);
  });
}
