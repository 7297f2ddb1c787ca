#include "capi/pictures/pixels.hpp"

#include <cstdint>

namespace sfumato::capi {

std::size_t row_pixel_bytes(PixelFormat format, std::int32_t width) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(channel_count(format)) *
         static_cast<std::size_t>(bytes_per_channel(format));
}

std::optional<PixelFormat> format_of(const sfumato_image* image) {
  if (!image || !image->pixels || image->width < 1 || image->height < 1) return std::nullopt;
  if (image->format < SFUMATO_RGB8 || image->format > SFUMATO_RGBA16) return std::nullopt;
  static_assert(static_cast<int>(PixelFormat::rgba16) == SFUMATO_RGBA16);
  const auto format = static_cast<PixelFormat>(image->format);
  if (image->row_bytes < row_pixel_bytes(format, image->width)) return std::nullopt;
  if (image->row_bytes > PTRDIFF_MAX / static_cast<std::size_t>(image->height)) return std::nullopt;
  return format;
}

}  // namespace sfumato::capi
