#include "codecs/data_uri_write.hpp"

#include <algorithm>
#include <array>

#include "base/charge.hpp"
#include "base/try.hpp"
#include "codecs/base64.hpp"
#include "sfumato/codecs/png.hpp"

namespace sfumato::codecs {
namespace {

constexpr std::array<std::uint8_t, 8> kPngMagic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<std::uint8_t, 3> kJpegMagic{0xff, 0xd8, 0xff};

bool starts_with(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> start) {
  return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

}  // namespace

Result<std::vector<std::uint8_t>> texture_png(Context& context, const Texture& texture) {
#if defined(__wasm__)
  static_cast<void>(context);
  static_cast<void>(texture);
  return make_error(StatusCode::unavailable,
                    "a texture that came from no file cannot be saved here; use a PNG or JPEG");
#else
  TableMemory memory("a texture to be saved");
  Image image{texture.width, texture.height, PixelFormat::rgba8, {}};
  SFUMATO_TRY(memory.append(context, texture.rgba, image.bytes));
  return encode_png(context, image);
#endif
}

std::string_view image_media_type(std::span<const std::uint8_t> file) {
  if (starts_with(file, kPngMagic)) return "image/png";
  if (starts_with(file, kJpegMagic)) return "image/jpeg";
  return {};
}

void append_data_uri(const Context& context, std::string_view media_type,
                     std::span<const std::uint8_t> bytes, OutputBuffer& text) {
  ((text += "data:") += media_type) += ";base64,";
  append_base64(context, bytes, text);
}

Result<std::string> data_uri(Context& context, const Texture& texture, TableMemory& memory) {
  std::string_view type = image_media_type(texture.file);
  std::vector<std::uint8_t> png;
  ScopedCharge held;
  if (type.empty()) {
    SFUMATO_TRY_ASSIGN(png, texture_png(context, texture));
    type = "image/png";
    SFUMATO_TRY(held.add(context, capacity_bytes(png), "a texture to be saved"));
  }
  std::string text = "data:" + std::string(type) + ";base64,";
  SFUMATO_TRY(append_base64(context, png.empty() ? texture.file : png, memory, text));
  return text;
}

}  // namespace sfumato::codecs
