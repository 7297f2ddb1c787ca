// WebAssembly: the codecs that libraries of the native build bring. Pictures are the browser's own
// affair there.
#include "codecs/gunzip.hpp"
#include "codecs/image_file.hpp"

namespace sfumato::codecs {

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> gunzip(Context&, std::string_view, TableMemory&) {
  return make_error(StatusCode::unavailable, "gzip is not unpacked here; expected the SVG itself");
}

Result<RgbaImage> decode_image(Context&, std::span<const std::uint8_t>) {
  return make_error(StatusCode::unavailable,
                    "images are not decoded here; expected their pixels beside the document");
}

}  // namespace sfumato::codecs
