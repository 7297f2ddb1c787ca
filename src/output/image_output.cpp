#include "output/image_output.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "picture/cover.hpp"
#include "sfumato/codecs/jpeg_encode.hpp"
#include "sfumato/codecs/png.hpp"
#include "sfumato/codecs/webp_encode.hpp"

namespace sfumato::output {
namespace {

/// Returns whether all pixels of a row with four channels are opaque. There is no branch per pixel,
/// so that the compiler can vectorise the loop.
template <std::size_t kChannelBytes>
bool is_opaque(const std::uint8_t* row, std::size_t width) {
  std::uint8_t all = 255;
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t i = 0; i < kChannelBytes; ++i) all &= row[(4 * x + 3) * kChannelBytes + i];
  }
  return all == 255;
}

/// Moves pixels of four channels to the places of pixels of three channels, `to` or before. Each
/// pixel moves with its alpha, which the next pixel overwrites.
template <std::size_t kChannelBytes>
void move_colors(const std::uint8_t* from, std::size_t width, std::uint8_t* to) {
  for (std::size_t x = 0; x < width; ++x) {
    std::array<std::uint8_t, 4 * kChannelBytes> pixel;
    std::memcpy(pixel.data(), from + 4 * kChannelBytes * x, pixel.size());
    std::memcpy(to + 3 * kChannelBytes * x, pixel.data(), pixel.size());
  }
}

template <std::size_t kChannelBytes>
Status drop_opaque_alpha_of(const Context& context, PixelFormat without, Image& image) {
  const auto width = static_cast<std::size_t>(image.width),
             height = static_cast<std::size_t>(image.height);
  const std::size_t row_bytes = image.row_bytes();
  std::uint8_t* const bytes = image.bytes.data();
  for (std::size_t y = 0; y < height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    if (!is_opaque<kChannelBytes>(bytes + y * row_bytes, width)) return ok_status();
  }
  image.format = without;
  for (std::size_t y = 0; y < height; ++y) {
    if (context.cancelled()) return context.cancel_status();
    move_colors<kChannelBytes>(bytes + y * row_bytes, width, bytes + y * image.row_bytes());
  }
  image.bytes.resize(image.row_bytes() * height);
  return ok_status();
}

/// Returns the pixels alone; channels of 16 bits have their low byte first.
Result<std::vector<std::uint8_t>> raw_frame(const Context& context, const Image& image) {
  TableMemory memory("a raw frame");
  std::vector<std::uint8_t> bytes;
  SFUMATO_TRY(memory.append(context, image.bytes, bytes));
  if (std::endian::native == std::endian::big && bytes_per_channel(image.format) == 2) {
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
  }
  return bytes;
}

}  // namespace

PixelFormat with_alpha(PixelFormat format) {
  return bytes_per_channel(format) == 1 ? PixelFormat::rgba8 : PixelFormat::rgba16;
}

PixelFormat drawn_format(PixelFormat format, options::OutputKind kind, bool has_background) {
  return options::has_alpha(kind) || !has_background ? with_alpha(format) : format;
}

bool drops_opaque_alpha(const options::Settings& settings, options::OutputKind kind) {
  return !settings.no_background && !options::has_alpha(kind);
}

PixelFormat needed_format(PixelFormat format, const Picture& picture, const Box& viewport) {
  if (channel_count(format) != 4 || !picture::covers(picture, viewport)) return format;
  return bytes_per_channel(format) == 1 ? PixelFormat::rgb8 : PixelFormat::rgb16;
}

Status drop_opaque_alpha(Context& context, Image& image) {
  if (channel_count(image.format) != 4) return ok_status();
  return bytes_per_channel(image.format) == 1
             ? drop_opaque_alpha_of<1>(context, PixelFormat::rgb8, image)
             : drop_opaque_alpha_of<2>(context, PixelFormat::rgb16, image);
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
    case options::OutputKind::rgb24:
    case options::OutputKind::rgba:
    case options::OutputKind::rgb48le:
    case options::OutputKind::rgba64le:
      return raw_frame(context, image);
    default:
      return encode_png(context, image);
  }
}

}  // namespace sfumato::output
