// Files that the editor's module makes: PDF and SVG. The browser makes images from the pixels of
// sfumato_raster(), and pages from the viewer's payload.

#include "capi/context.hpp"
#include "capi/pictures/export_file.hpp"
#include "capi/pictures/file_format.hpp"
#include "capi/pictures/pixels.hpp"
#include "formats/text/suggestion.hpp"
#include "output/export_vector.hpp"

namespace sfumato::capi {
namespace {

using options::OutputKind;

Outcome refuse(const char* format, const char* instead) {
  OutputKind kind{};
  SFUMATO_TRY(read_format(format, kind));
  return make_error(StatusCode::unavailable,
                    "this module writes no " + text::quoted(format) + " files; use " + instead);
}

Outcome export_file(sfumato_context* context, const sfumato_picture* handle, const char* format,
                    const char* text, sfumato_bytes** out) {
  context->warnings.clear();
  if (!handle) return bad_usage("NULL given; pass a picture");
  OutputKind kind{};
  SFUMATO_TRY(read_format(format, kind));
  if (kind != OutputKind::pdf && kind != OutputKind::svg) {
    return refuse(format, "sfumato_raster or sfumato_viewer_payload");
  }
  options::Settings settings;
  SFUMATO_TRY(read_file_options(text, options::kExport, kind, settings));
  return export_drawing(context, *handle, kind, settings, output::export_vector, out);
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
                       const char*, sfumato_bytes** bytes) {
  using sfumato::capi::bad_usage;
  const auto body = [&](sfumato::capi::Workshop&) -> sfumato::capi::Outcome {
    if (!sfumato::capi::format_of(image)) return bad_usage(sfumato::capi::kNoImage);
    return sfumato::capi::refuse(format, "the host's own encoders");
  };
  return sfumato::capi::make(context, bytes, body);
}
