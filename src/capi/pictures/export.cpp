#include "base/charge.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "capi/pictures/export_file.hpp"
#include "capi/pictures/file_format.hpp"
#include "capi/pictures/picture.hpp"
#include "capi/pictures/pixels.hpp"
#include "output/image_output.hpp"
#include "output/output_size.hpp"
#include "raster/rasterize_into.hpp"

namespace sfumato::capi {
namespace {

using options::OutputKind;

Result<FileBytes> make_image(Context& context, const sfumato_picture& handle, OutputKind kind,
                             const options::Settings& settings) {
  const Picture& picture = handle.picture();
  const std::optional<Rgb> background = background_of(settings, kind, picture);
  const Box viewport = settings.diffuse.viewport.value_or(picture.viewport);
  SFUMATO_TRY_ASSIGN(const output::OutputSize& size,
                     output::output_size(context.limits, settings.size, viewport, handle.own_scale,
                                         settings.window.has_value()));
  RasterOptions options = settings.raster;
  options.format = output::drawn_format(options.format, kind, background.has_value());
  const bool drops_alpha = output::drops_opaque_alpha(settings, kind);
  if (drops_alpha) options.format = output::needed_format(options.format, picture, viewport);
  options.viewport = viewport;
  output::set_size(size, settings.window, options);
  SFUMATO_TRY_ASSIGN(auto&& image, raster::rasterize_on(context, picture, options, background));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context, capacity_bytes(image.bytes), "the image"));
  if (drops_alpha) SFUMATO_TRY(output::drop_opaque_alpha(context, image));
  return output::encode_image(context, image, kind, settings.output);
}

Outcome export_file(sfumato_context* context, const sfumato_picture* handle, const char* format,
                    const char* text, sfumato_bytes** out) {
  context->warnings.clear();
  if (!handle) return bad_usage("NULL given; pass a picture");
  OutputKind kind{};
  SFUMATO_TRY(read_format(format, kind));
  options::Settings settings;
  SFUMATO_TRY(read_file_options(text, options::kExport, kind, settings));
  Context& work = context->workshop->context;
  if (options::is_image(kind))
    return hand_out_bytes(make_image(work, *handle, kind, settings), out);
  return export_drawing(context, *handle, kind, settings, output::export_picture, out);
}

Outcome encode(Workshop& workshop, const sfumato_image* pixels, const char* format_name,
               const char* text, sfumato_bytes** out) {
  const std::optional<PixelFormat> format = format_of(pixels);
  if (!format) return bad_usage(kNoImage);
  OutputKind kind{};
  SFUMATO_TRY(read_format(format_name, kind));
  if (!options::is_image(kind)) return bad_usage("the format is not an image format");
  options::Settings settings;
  SFUMATO_TRY(read_file_options(text, options::kEncode, kind, settings));
  TableMemory memory("the image");
  SFUMATO_TRY_ASSIGN(auto&& image, copy_image(workshop.context, *pixels, *format, memory));
  return hand_out_bytes(output::encode_image(workshop.context, image, kind, settings.output), out);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_export(sfumato_context* context, const sfumato_picture* picture, const char* format,
                       const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop&) {
    return sfumato::capi::export_file(context, picture, format, options, bytes);
  });
}

int32_t sfumato_encode(sfumato_context* context, const sfumato_image* image, const char* format,
                       const char* options, sfumato_bytes** bytes) {
  return sfumato::capi::make(context, bytes, [&](sfumato::capi::Workshop& workshop) {
    return sfumato::capi::encode(workshop, image, format, options, bytes);
  });
}
