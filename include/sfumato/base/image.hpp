#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/limits.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

enum class PixelFormat : std::uint8_t { rgb8, rgba8, rgb16, rgba16 };

constexpr int channel_count(PixelFormat format) {
  return format == PixelFormat::rgb8 || format == PixelFormat::rgb16 ? 3 : 4;
}
constexpr int bytes_per_channel(PixelFormat format) {
  return format == PixelFormat::rgb8 || format == PixelFormat::rgba8 ? 1 : 2;
}

/// A raster image, row by row from the top, sRGB code values, alpha not premultiplied; 16-bit
/// channels in the machine's byte order.
struct Image {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::rgb8;
  std::vector<std::uint8_t> bytes;

  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * channel_count(format) * bytes_per_channel(format);
  }
};

/// Whether it has pixels, at most Limits::image_side on a side, a known format, and the bytes of
/// all of them. Errors: bad_input, limit.
Status validate(const Limits& limits, const Image& image);

}  // namespace sfumato
