#include "codecs/image_file.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "base/channel.hpp"
#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "codecs/jpeg_decode.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::codecs {
namespace {

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 3> kJpegSignature{0xFF, 0xD8, 0xFF};

/// Where the header's width and height stand, big end first.
constexpr std::size_t kPngWidthAt = 16;
constexpr std::size_t kPngHeightAt = 20;

template <std::size_t N>
bool starts_with(std::span<const std::uint8_t> bytes, const std::array<std::uint8_t, N>& begin) {
  return bytes.size() >= N && std::memcmp(bytes.data(), begin.data(), N) == 0;
}

std::uint64_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  if (bytes.size() < at + 4) return 0;
  return std::uint64_t{bytes[at]} << 24 | std::uint64_t{bytes[at + 1]} << 16 |
         std::uint64_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

/// The bytes of an image of 16 bits become those of one of 8; meanwhile both are charged.
Status halve_depth(const Context& context, std::vector<std::uint8_t>& bytes) {
  ScopedCharge held;
  Status status = held.add(context, capacity_bytes(bytes), "a PNG image of 16 bits");
  if (!status) return status;
  TableMemory memory("a PNG image of 16 bits");
  std::vector<std::uint8_t> halved;
  if (status = memory.resize(context, halved, bytes.size() / 2); !status) return status;
  RarePoll<65536> poll(context);
  for (std::size_t i = 0; i < halved.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    halved[i] = rounded_to_8_bits(&bytes[2 * i]);
  }
  bytes = std::move(halved);
  return ok_status();
}

Result<RgbaImage> from_png(Context& context, std::span<const std::uint8_t> bytes) {
  if (Status sized = check_png_size(context.limits, bytes); !sized) return sized;
  Result<Image> image = decode_png_with_alpha(context, bytes, {});
  if (!image) return image.status();
  if (image->format == PixelFormat::rgba16) {
    if (Status status = halve_depth(context, image->bytes); !status) return status;
  }
  return RgbaImage{image->width, image->height, std::move(image->bytes)};
}

}  // namespace

Status check_png_size(const Limits& limits, std::span<const std::uint8_t> png) {
  return check_image_size(limits, number_at(png, kPngWidthAt), number_at(png, kPngHeightAt));
}

Result<RgbaImage> decode_image(Context& context, std::span<const std::uint8_t> bytes) {
  if (starts_with(bytes, kPngSignature)) return from_png(context, bytes);
  if (starts_with(bytes, kJpegSignature)) return decode_jpeg(context, bytes);
  return make_error(StatusCode::bad_input, "the image is neither a PNG nor a JPEG");
}

}  // namespace sfumato::codecs
