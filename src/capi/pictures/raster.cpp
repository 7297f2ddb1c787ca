#include "base/try.hpp"
#include "capi/documents/read_options.hpp"
#include "capi/pictures/picture.hpp"
#include "capi/pictures/pixels.hpp"
#include "options/settle.hpp"
#include "options/tables.hpp"
#include "output/output_size.hpp"
#include "raster/rasterize_into.hpp"

namespace sfumato::capi {
namespace {

/// Sets the image's size and the window's place in the picture.
Outcome set_size(const Limits& limits, const sfumato_picture& handle, const sfumato_image& image,
                 options::Settings& settings) {
  const options::SizeRequest& asked = settings.size;
  SFUMATO_TRY(expect_none(options::find_conflict(settings, options::OutputKind::png)));
  const output::OutputSize own_size{image.width, image.height};
  if (!settings.window) {
    if (asked.width || asked.height || asked.scale)
      return bad_usage(
          "width, height and scale: work with window only, because the image has its own size");
    output::set_size(own_size, settings.window, settings.raster);
    return {};
  }
  const PixelRect& window = *settings.window;
  if (window.x1 - window.x0 != image.width || window.y1 - window.y0 != image.height)
    return bad_usage("window: of another size than the image");
  const Box viewport = settings.diffuse.viewport.value_or(handle.picture().viewport);
  SFUMATO_TRY_ASSIGN(const output::OutputSize& size,
                     output::output_size(limits, asked, viewport, handle.own_scale, true));
  output::set_size(size, settings.window, settings.raster);
  return {};
}

Outcome draw(Workshop& workshop, const sfumato_picture* handle, const sfumato_image* image,
             const char* text) {
  if (!handle) return bad_usage("NULL given; pass a picture");
  const std::optional<PixelFormat> format = format_of(image);
  if (!format) return bad_usage(kNoImage);
  options::Settings settings;
  SFUMATO_TRY(read_options(text, options::kRaster, options::render_options(), settings));
  RasterOptions& options = settings.raster;
  SFUMATO_TRY(set_size(workshop.context.limits, *handle, *image, settings));
  options.format = *format;
  options.viewport = settings.diffuse.viewport;
  options.dither = settings.dither.value_or(false);
  const Picture& picture = handle->picture();
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
