#include "output/image_output.hpp"

#include <algorithm>

#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato::output {
namespace {

bool is_opaque(const std::uint8_t* row, int width, int channel_bytes) {
  const int pixel_bytes = 4 * channel_bytes;
  for (int x = 0; x < width; ++x) {
    const std::uint8_t* alpha = row + x * pixel_bytes + 3 * channel_bytes;
    for (int i = 0; i < channel_bytes; ++i)
      if (alpha[i] != 255) return false;
  }
  return true;
}

}  // namespace

PixelFormat with_alpha(PixelFormat format) {
  return bytes_per_channel(format) == 1 ? PixelFormat::rgba8 : PixelFormat::rgba16;
}

Status drop_opaque_alpha(Context& context, Image& image) {
  if (channel_count(image.format) != 4) return ok_status();
  const int channel_bytes = bytes_per_channel(image.format);
  const std::size_t old_row_bytes = image.row_bytes();
  for (int y = 0; y < image.height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    const std::uint8_t* row = image.bytes.data() + static_cast<std::size_t>(y) * old_row_bytes;
    if (!is_opaque(row, image.width, channel_bytes)) return ok_status();
  }
  image.format = channel_bytes == 1 ? PixelFormat::rgb8 : PixelFormat::rgb16;
  const std::uint8_t* in = image.bytes.data();
  std::uint8_t* out = image.bytes.data();
  for (int y = 0; y < image.height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    for (int x = 0; x < image.width; ++x, in += 4 * channel_bytes, out += 3 * channel_bytes) {
      std::copy_n(in, 3 * channel_bytes, out);  // forwards: it may overlap
    }
  }
  image.bytes.resize(image.row_bytes() * static_cast<std::size_t>(image.height));
  return ok_status();
}

Result<std::vector<std::uint8_t>> encode_image(Context& context, const Image& image,
                                               options::OutputKind kind,
                                               const options::OutputOptions& options) {
  switch (kind) {
    case options::OutputKind::jpeg:
      return encode_jpeg(context, image, *options.quality);
    case options::OutputKind::webp:
      return encode_webp(context, image,
                         {.lossless = options.lossless, .quality = *options.quality});
    default:
      return encode_png(context, image);
  }
}

}  // namespace sfumato::output
