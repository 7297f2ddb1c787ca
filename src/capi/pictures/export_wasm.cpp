// WebAssembly has no codecs to write files. The browser makes files from the pixels of
// sfumato_raster(), and pages from the viewer's payload.

#include "capi/context.hpp"
#include "capi/pictures/file_format.hpp"
#include "capi/pictures/pixels.hpp"
#include "formats/text/suggestion.hpp"

namespace sfumato::capi {
namespace {

Outcome refuse(const char* format, const char* instead) {
  options::OutputKind kind{};
  SFUMATO_TRY(read_format(format, kind));
  return make_error(StatusCode::unavailable,
                    "WebAssembly writes no " + text::quoted(format) + " files; use " + instead);
}

}  // namespace
}  // namespace sfumato::capi

int32_t sfumato_export(sfumato_context* context, const sfumato_picture* picture, const char* format,
                       const char*, sfumato_bytes** bytes) {
  using sfumato::capi::bad_usage;
  const auto body = [&](sfumato::capi::Workshop&) -> sfumato::capi::Outcome {
    context->warnings.clear();
    if (!picture) return bad_usage("NULL given; pass a picture");
    return sfumato::capi::refuse(format, "sfumato_raster or sfumato_viewer_payload");
  };
  return sfumato::capi::make(context, bytes, body);
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
