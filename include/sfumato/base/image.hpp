#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Channels of a pixel, in this order, and the bits of each.
enum class PixelFormat : std::uint8_t {
  rgb8,   ///< 3 bytes a pixel
  rgba8,  ///< 4 bytes a pixel
  rgb16,  ///< 6 bytes a pixel
  rgba16  ///< 8 bytes a pixel
};

/// Returns 3, or with alpha 4.
constexpr int channel_count(PixelFormat format) {
  return format == PixelFormat::rgb8 || format == PixelFormat::rgb16 ? 3 : 4;
}
/// Returns 1 or 2.
constexpr int bytes_per_channel(PixelFormat format) {
  return format == PixelFormat::rgb8 || format == PixelFormat::rgba8 ? 1 : 2;
}

/// A raster image of sRGB code values; alpha is not premultiplied.
struct Image {
  int width = 0;                           ///< pixels
  int height = 0;                          ///< pixels
  PixelFormat format = PixelFormat::rgb8;  ///< of each pixel
  /// Row by row from the top, without padding: height × row_bytes() bytes. Channels of 16 bits are
  /// in the machine's byte order.
  std::vector<std::uint8_t> bytes;

  /// Returns the bytes from one row to the next.
  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * channel_count(format) * bytes_per_channel(format);
  }
};

/// Checks that an image has pixels, at most Limits::image_side of them on a side, a known format,
/// and the number of bytes for these. Errors: bad_input, limit.
Status validate(const Limits& limits, const Image& image);

}  // namespace sfumato
