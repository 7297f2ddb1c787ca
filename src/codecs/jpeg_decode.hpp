#pragma once

#include <cstdint>
#include <span>

#include "codecs/image_file.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Decodes a JPEG: gray, YCbCr, RGB, and CMYK and YCCK as Adobe writes them, inverted (without
/// their profile: colours are near, not exact). The size is held against limits::kImageSide and
/// kTexels and memory is charged before it is taken. A file that ends early is an error, not a
/// gray rest. Errors: bad_input, limit, out_of_memory, without a place.
Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::codecs
