#include "capi/pictures/pixels.hpp"

#include <cstdint>

#include "base/try.hpp"

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

Result<Image> copy_image(const Context& context, const sfumato_image& from, PixelFormat format,
                         TableMemory& memory) {
  Image image{from.width, from.height, format, {}};
  const auto height = static_cast<std::size_t>(from.height);
  SFUMATO_TRY(memory.reserve(context, image.bytes, height * image.row_bytes()));
  const auto* row = static_cast<const std::uint8_t*>(from.pixels);
  for (std::size_t y = 0; y < height; ++y, row += from.row_bytes) {
    if (context.cancelled()) return context.cancel_status();
    image.bytes.insert(image.bytes.end(), row, row + image.row_bytes());
  }
  return image;
}

}  // namespace sfumato::capi
