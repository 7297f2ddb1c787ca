#include "cli/image_output.hpp"

#include "formats/jpeg_encode.hpp"
#include "formats/png.hpp"
#include "formats/webp_encode.hpp"

namespace sfumato::cli {

Result<std::vector<std::uint8_t>> encode_image(Context& context, const Image& image,
                                               const OutputOptions& options) {
  switch (options.kind) {
    case OutputKind::jpeg:
      return encode_jpeg(context, image, options.quality);
    case OutputKind::webp:
      return encode_webp(context, image,
                         {.lossless = options.lossless, .quality = options.quality});
    default:
      return encode_png(context, image);
  }
}

}  // namespace sfumato::cli
