#include "codecs/photo/photo_webp.hpp"

#include <webp/decode.h>
#include <webp/demux.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/charge.hpp"
#include "base/owned.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/image_file.hpp"

namespace sfumato::codecs {
namespace {

/// The library's own memory: the whole pixels and alpha of a lossless file; rows; and the largest
/// tables of codes that its own encoder makes.
constexpr std::size_t kWorkingBytesPerPixel = 5;
constexpr std::size_t kWorkingBytes = std::size_t{56} << 20;
/// For a small file: its tables have at most as many codes as the file has bits.
constexpr std::size_t kWorkingBytesPerByte = 8192;

/// The least number of polls of the cancel flag: the library decodes all bytes that it is given.
constexpr std::size_t kParts = 256;

Status damaged(const std::string& how) {
  return make_error(StatusCode::bad_input, "the WebP image is damaged: " + how);
}

Status no_memory() {
  return make_error(StatusCode::out_of_memory, "no memory to read the WebP image");
}

/// The error of a call that reads the whole input.
Status status_of(VP8StatusCode code) {
  switch (code) {
    case VP8_STATUS_OK:
      return ok_status();
    case VP8_STATUS_OUT_OF_MEMORY:
      return no_memory();
    case VP8_STATUS_NOT_ENOUGH_DATA:
    case VP8_STATUS_SUSPENDED:
      return damaged("it ends early");
    case VP8_STATUS_UNSUPPORTED_FEATURE:
      return make_error(StatusCode::bad_input, "a WebP image of a kind that cannot be read");
    default:
      return damaged("its codes make no picture");
  }
}

/// Takes the content of the first chunk of that name; empty if there is none.
Status take_chunk(const Context& context, const WebPDemuxer* demuxer, const char* name,
                  TableMemory& memory, std::vector<std::uint8_t>& content) {
  WebPChunkIterator chunk;
  Status status;
  if (WebPDemuxGetChunk(demuxer, name, 1, &chunk)) {
    status = memory.append(context, std::span(chunk.chunk.bytes, chunk.chunk.size), content);
  }
  WebPDemuxReleaseChunkIterator(&chunk);
  return status;
}

Status take_chunks(const Context& context, std::span<const std::uint8_t> bytes, TableMemory& memory,
                   WebpPhoto& photo) {
  const WebPData data{bytes.data(), bytes.size()};
  WebPDemuxState state = WEBP_DEMUX_PARSE_ERROR;
  const Owned<WebPDemuxer, WebPDemuxDelete> demuxer(WebPDemuxPartial(&data, &state));
  if (state == WEBP_DEMUX_PARSING_HEADER || state == WEBP_DEMUX_PARSED_HEADER) {
    return damaged("it ends early");
  }
  if (!demuxer) return damaged("its chunks do not fit");
  SFUMATO_TRY(take_chunk(context, demuxer.get(), "ICCP", memory, photo.profile));
  return take_chunk(context, demuxer.get(), "EXIF", memory, photo.exif);
}

Status decode_pixels(const Context& context, std::span<const std::uint8_t> bytes, Image& image) {
  const bool has_alpha = image.format == PixelFormat::rgba8;
  const Owned<WebPIDecoder, WebPIDelete> decoder(WebPINewRGB(has_alpha ? MODE_RGBA : MODE_RGB,
                                                             image.bytes.data(), image.bytes.size(),
                                                             static_cast<int>(image.row_bytes())));
  if (!decoder) return no_memory();
  const std::size_t part = std::max<std::size_t>(bytes.size() / kParts, 1024);
  VP8StatusCode code = VP8_STATUS_SUSPENDED;
  for (std::size_t end = 0; end < bytes.size() && code == VP8_STATUS_SUSPENDED;) {
    if (context.cancelled()) return context.cancel_status();
    end = std::min(bytes.size(), end + part);
    code = WebPIUpdate(decoder.get(), bytes.data(), end);
  }
  return status_of(code);
}

}  // namespace

Result<WebpPhoto> decode_webp_photo(Context& context, std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  SFUMATO_TRY(status_of(WebPGetFeatures(bytes.data(), bytes.size(), &features)));
  if (features.has_animation) {
    return make_error(StatusCode::bad_input, "an animated WebP; use a still picture");
  }
  const auto width = static_cast<std::size_t>(features.width);
  const auto height = static_cast<std::size_t>(features.height);
  SFUMATO_TRY(check_image_size(context.limits, width, height));
  ScopedCharge charge;
  SFUMATO_TRY(charge.add(context,
                         width * height * kWorkingBytesPerPixel +
                             std::min(kWorkingBytes, bytes.size() * kWorkingBytesPerByte),
                         "a WebP image"));
  TableMemory memory("a WebP image");
  WebpPhoto photo;
  photo.image = {features.width,
                 features.height,
                 features.has_alpha ? PixelFormat::rgba8 : PixelFormat::rgb8,
                 {}};
  SFUMATO_TRY(memory.resize(context, photo.image.bytes, photo.image.row_bytes() * height));
  SFUMATO_TRY(take_chunks(context, bytes, memory, photo));
  SFUMATO_TRY(decode_pixels(context, bytes, photo.image));
  return photo;
}

}  // namespace sfumato::codecs
