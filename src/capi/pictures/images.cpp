#include "capi/pictures/images.hpp"

#include <algorithm>
#include <utility>

#include "base/channel.hpp"
#include "base/try.hpp"
#include "capi/context.hpp"
#include "capi/pictures/pixels.hpp"
#include "codecs/image_file.hpp"

namespace sfumato::capi {
namespace {

std::uint8_t channel_at(const std::uint8_t* pixel, PixelFormat format, int channel) {
  if (bytes_per_channel(format) == 1) return pixel[channel];
  return rounded_to_8_bits(pixel + 2 * channel);
}

void append_row(const std::uint8_t* row, int width, PixelFormat format,
                std::vector<std::uint8_t>& rgba) {
  const std::size_t pixel_bytes = row_pixel_bytes(format, 1);
  for (int x = 0; x < width; ++x, row += pixel_bytes) {
    for (int channel = 0; channel < 3; ++channel) {
      rgba.push_back(channel_at(row, format, channel));
    }
    rgba.push_back(channel_count(format) == 4 ? channel_at(row, format, 3) : 255);
  }
}

/// Copies the pixels of an image within the limits, row after row. Errors: limit (memory),
/// cancelled.
Status copy_pixels(const Context& context, const sfumato_image& image, PixelFormat format,
                   TableMemory& memory, std::vector<std::uint8_t>& rgba) {
  const auto height = static_cast<std::size_t>(image.height);
  const std::size_t row_bytes = row_pixel_bytes(PixelFormat::rgba8, image.width);
  SFUMATO_TRY(memory.reserve(context, rgba, row_bytes * height));
  const auto* row = static_cast<const std::uint8_t*>(image.pixels);
  for (std::size_t y = 0; y < height; ++y, row += image.row_bytes) {
    if (context.cancelled()) return context.cancel_status();
    append_row(row, image.width, format, rgba);
  }
  return ok_status();
}

}  // namespace

Outcome Images::put(const Context& context, std::span<const std::uint8_t> file,
                    const sfumato_image* image) {
  const std::optional<PixelFormat> format = format_of(image);
  if (!format) return bad_usage(kNoImage);
  forget(file);
  Known known;
  known.width = image->width;
  known.height = image->height;
  SFUMATO_TRY(codecs::check_image_size(context.limits, static_cast<std::size_t>(image->width),
                                       static_cast<std::size_t>(image->height)));
  SFUMATO_TRY(known.memory.append(context, file, known.file));
  SFUMATO_TRY(copy_pixels(context, *image, *format, known.memory, known.rgba));
  images_.push_back(std::move(known));
  return ok_status();
}

void Images::forget(std::span<const std::uint8_t> file) {
  std::erase_if(images_,
                [file](const Known& known) { return std::ranges::equal(known.file, file); });
}

std::optional<ImagePixels> Images::find(std::span<const std::uint8_t> file) const {
  const auto found = std::ranges::find_if(
      images_, [file](const Known& known) { return std::ranges::equal(known.file, file); });
  if (found == images_.end()) return std::nullopt;
  return ImagePixels{found->width, found->height, found->rgba};
}

}  // namespace sfumato::capi

int32_t sfumato_add_image(sfumato_context* context, const void* bytes, size_t byte_count,
                          const sfumato_image* image) {
  using sfumato::capi::bad_usage;
  const auto body = [&](sfumato::capi::Workshop& workshop) -> sfumato::capi::Outcome {
    if (!bytes || byte_count == 0) return bad_usage("no bytes of an image file");
    const std::span file(static_cast<const std::uint8_t*>(bytes), byte_count);
    if (image) return context->images.put(workshop.context, file, image);
    context->images.forget(file);
    return {};
  };
  return sfumato::capi::call(context, body);
}
