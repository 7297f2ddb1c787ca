#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

struct RgbaImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< row by row, 4 × width × height, not premultiplied
};

/// Decodes a PNG or a JPEG; the first bytes decide which. 16 bits are rounded to 8; colour profiles
/// and orientation tags are not applied. The size is checked against the limits of a side and of
/// texels, and memory is charged before it is allocated. Errors: bad_input, limit, cancelled,
/// out_of_memory, without a place.
Result<RgbaImage> decode_image(Context& context, std::span<const std::uint8_t> bytes);

/// Checks the size in a PNG's header, before it is read. Errors: limit.
Status check_png_size(const Limits& limits, std::span<const std::uint8_t> png);

/// Checks the size in a file's header against the limits of a texture. Errors: limit.
Status check_image_size(const Limits& limits, std::uint64_t width, std::uint64_t height);

}  // namespace sfumato::codecs
