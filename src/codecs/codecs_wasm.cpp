// WebAssembly stand-ins for the codecs that the native build takes from libraries. In WebAssembly
// the host decodes and encodes pictures.
#include "codecs/gunzip.hpp"
#include "codecs/image_file.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato {
namespace {

Status no_encoder() {
  return make_error(StatusCode::unavailable,
                    "no JPEG and no WebP is written here; use \"png\", or pixels for the host's "
                    "own encoders");
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_jpeg(Context&, const Image&, int) {
  return no_encoder();
}

Result<std::vector<std::uint8_t>> encode_webp(Context&, const Image&, const WebpOptions&) {
  return no_encoder();
}

namespace codecs {

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> gunzip(Context&, std::string_view, TableMemory&) {
  return make_error(StatusCode::unavailable, "gzip is not unpacked here; use the SVG itself");
}

Result<RgbaImage> decode_image(Context&, std::span<const std::uint8_t>) {
  return make_error(StatusCode::unavailable,
                    "images are not decoded here; use their pixels beside the document");
}

}  // namespace codecs
}  // namespace sfumato
