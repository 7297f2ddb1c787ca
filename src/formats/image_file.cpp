#include "formats/image_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "base/image.hpp"
#include "base/limits.hpp"
#include "formats/jpeg_decode.hpp"
#include "formats/png.hpp"

namespace sfumato {
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

/// 16 bits to 8, rounded.
std::uint8_t rounded(const std::uint8_t* big_or_little) {
  std::uint16_t value = 0;
  std::memcpy(&value, big_or_little, sizeof(value));
  return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

Result<RgbaImage> to_rgba(Context& context, const Image& image) {
  const bool has_alpha = image.format == PixelFormat::rgba8 || image.format == PixelFormat::rgba16;
  const bool is_wide = image.format == PixelFormat::rgb16 || image.format == PixelFormat::rgba16;
  const std::size_t channels = has_alpha ? 4 : 3;
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  ScopedCharge charge;
  if (Status status = charge.add(context, 4 * pixel_count, "a texture"); !status) return status;
  RgbaImage result{image.width, image.height, std::vector<std::uint8_t>(4 * pixel_count, 255)};
  for (std::size_t i = 0; i < pixel_count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t from = channels * i + c;
      result.rgba[4 * i + c] = is_wide ? rounded(&image.bytes[2 * from]) : image.bytes[from];
    }
  }
  return result;
}

Result<RgbaImage> from_png(Context& context, std::span<const std::uint8_t> bytes) {
  Status sized = check_image_size(context.limits, number_at(bytes, kPngWidthAt),
                                  number_at(bytes, kPngHeightAt));
  if (!sized) return sized;
  Result<Image> image = decode_png(context, bytes, {});
  if (!image) return image.status();
  if (image->format == PixelFormat::rgba8) {
    return RgbaImage{image->width, image->height, std::move(image->bytes)};
  }
  return to_rgba(context, *image);
}

}  // namespace

Status check_image_size(const Limits& limits, std::uint64_t width, std::uint64_t height) {
  const std::string size =
      "an image of " + std::to_string(width) + " × " + std::to_string(height) + " pixels";
  if (std::max(width, height) > limits.image_side) {
    return make_error(
        StatusCode::limit,
        size + "; the limit is " + limit_text(limits, &Limits::image_side, "pixels on a side"));
  }
  if (width * height > limits.texels) {
    return make_error(StatusCode::limit,
                      size + "; the limit is " + limit_text(limits, &Limits::texels, "texels"));
  }
  return ok_status();
}

Result<RgbaImage> decode_image(Context& context, std::span<const std::uint8_t> bytes) {
  if (starts_with(bytes, kPngSignature)) return from_png(context, bytes);
  if (starts_with(bytes, kJpegSignature)) return decode_jpeg(context, bytes);
  return make_error(StatusCode::bad_input, "the image is neither a PNG nor a JPEG");
}

}  // namespace sfumato
