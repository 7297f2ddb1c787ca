#include "sfumato/codecs/webp_encode.hpp"

#include <webp/encode.h>

#include <string>

#include "base/charge.hpp"
#include "base/owned.hpp"
#include "base/public_verb.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/webp/webp_import.hpp"

namespace sfumato {
namespace {

/// The library's own memory: the picture as ARGB or YUVA, statistics, the lossless coder's history
/// (its hash chain and histograms), and the growing file. The library allocates it, so the figure
/// is an estimate.
constexpr std::size_t kWebpEncoderBytesPerPixel = 40;
constexpr std::size_t kWebpEncoderBytes = std::size_t{4} << 20;

int go_on(int, const WebPPicture* picture) {
  return static_cast<const Context*>(picture->user_data)->cancelled() ? 0 : 1;
}

Status failure(const WebPPicture& picture) {
  switch (picture.error_code) {
    case VP8_ENC_ERROR_USER_ABORT:
      return static_cast<const Context*>(picture.user_data)->cancel_status();
    case VP8_ENC_OK:  // libwebp sets this if some of its allocations fail
    case VP8_ENC_ERROR_OUT_OF_MEMORY:
    case VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY:
    case VP8_ENC_ERROR_BAD_WRITE:  // into memory
      return make_error(StatusCode::out_of_memory, "no memory to write the WebP image");
    case VP8_ENC_ERROR_FILE_TOO_BIG:
      return make_error(StatusCode::limit, "a WebP file holds at most 4 GiB");
    default:
      return make_error(StatusCode::internal,
                        "writing a WebP: error " + std::to_string(picture.error_code));
  }
}

Status check(const Limits& limits, const Image& image, const WebpOptions& options) {
  SFUMATO_TRY(validate(limits, image));
  if (!options.lossless && (options.quality < 1 || options.quality > 100)) {
    return make_error(StatusCode::bad_input, "the quality of a WebP must be from 1 to 100");
  }
  if (bytes_per_channel(image.format) != 1) {
    return make_error(StatusCode::bad_input, "WebP holds 8 bits per channel");
  }
  if (image.width > kWebpSide || image.height > kWebpSide) {
    return make_error(StatusCode::limit, "a WebP image has at most " + std::to_string(kWebpSide) +
                                             " pixels on a side");
  }
  return ok_status();
}

WebPConfig configuration(const WebpOptions& options) {
  WebPConfig config;
  WebPConfigInit(&config);
  config.lossless = options.lossless ? 1 : 0;
  config.exact = options.lossless ? 1 : 0;
  config.quality = options.lossless ? 75.0f : static_cast<float>(options.quality);
  return config;
}

Result<std::vector<std::uint8_t>> encode(Context& context, const Image& image,
                                         const WebpOptions& options) {
  SFUMATO_TRY(check(context.limits, image, options));
  ScopedCharge charge;
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  {
    const std::size_t parts = options.lossless ? 0 : codecs::import_bytes(context.thread_count());
    SFUMATO_TRY(charge.add(context,
                           kWebpEncoderBytes + parts + kWebpEncoderBytesPerPixel * pixel_count,
                           "writing a WebP image"));
  }
  WebPPicture picture;
  WebPPictureInit(&picture);
  const Owned<WebPPicture, WebPPictureFree> picture_guard(&picture);
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  const Owned<WebPMemoryWriter, WebPMemoryWriterClear> writer_guard(&writer);
  picture.width = image.width;
  picture.height = image.height;
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  picture.progress_hook = go_on;
  picture.user_data = &context;
  const WebPConfig config = configuration(options);
  SFUMATO_TRY(options.lossless ? codecs::import_argb(context, image, picture)
                               : codecs::import_yuv(context, image, picture));
  if (WebPEncode(&config, &picture) == 0) return failure(picture);
  TableMemory memory("a WebP image");
  std::vector<std::uint8_t> file;
  SFUMATO_TRY(memory.append(context, {writer.mem, writer.size}, file));
  return file;
}

}  // namespace

Result<std::vector<std::uint8_t>> encode_webp(Context& context, const Image& image,
                                              const WebpOptions& options) {
  return public_verb(context, [&] { return encode(context, image, options); });
}

}  // namespace sfumato
