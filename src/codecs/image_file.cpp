#include "codecs/image_file.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "base/channel.hpp"
#include "base/charge.hpp"
#include "base/poll.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "codecs/file_kind.hpp"
#include "codecs/jpeg/jpeg_decode.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::codecs {
namespace {

/// The places of the header's width and height, big-endian.
constexpr std::size_t kPngWidthAt = 16;
constexpr std::size_t kPngHeightAt = 20;

std::uint64_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  if (bytes.size() < at + 4) return 0;
  return std::uint64_t{bytes[at]} << 24 | std::uint64_t{bytes[at + 1]} << 16 |
         std::uint64_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

/// Turns an image of 16 bits into an image of 8 bits. Both are charged meanwhile.
Status halve_depth(const Context& context, std::vector<std::uint8_t>& bytes) {
  ScopedCharge held;
  SFUMATO_TRY(held.add(context, capacity_bytes(bytes), "a PNG image of 16 bits"));
  TableMemory memory("a PNG image of 16 bits");
  std::vector<std::uint8_t> halved;
  SFUMATO_TRY(memory.resize(context, halved, bytes.size() / 2));
  RarePoll<65536> poll(context);
  for (std::size_t i = 0; i < halved.size(); ++i) {
    if (poll.cancelled()) return context.cancel_status();
    halved[i] = rounded_to_8_bits(&bytes[2 * i]);
  }
  bytes = std::move(halved);
  return ok_status();
}

Result<RgbaImage> from_png(Context& context, std::span<const std::uint8_t> bytes) {
  SFUMATO_TRY(check_png_size(context.limits, bytes));
  SFUMATO_TRY_ASSIGN(auto&& image, decode_png_with_alpha(context, bytes, {}));
  if (image.format == PixelFormat::rgba16) {
    SFUMATO_TRY(halve_depth(context, image.bytes));
  }
  return RgbaImage{image.width, image.height, std::move(image.bytes)};
}

}  // namespace

Status check_png_size(const Limits& limits, std::span<const std::uint8_t> png) {
  return check_image_size(limits, number_at(png, kPngWidthAt), number_at(png, kPngHeightAt));
}

Result<RgbaImage> decode_image(Context& context, std::span<const std::uint8_t> bytes) {
  const FileKind kind = file_kind(text_view(bytes));
  if (kind == FileKind::png) return from_png(context, bytes);
  if (kind == FileKind::jpeg) return decode_jpeg(context, bytes);
  std::string message = "the image is neither a PNG nor a JPEG";
  if (!kind_text(kind).empty()) message += ", but " + std::string(kind_text(kind));
  return make_error(StatusCode::bad_input, message);
}

}  // namespace sfumato::codecs
