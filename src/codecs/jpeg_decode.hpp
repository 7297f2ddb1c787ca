#pragma once

#include <cstdint>
#include <span>

#include "codecs/image_file.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Decodes a JPEG: gray, YCbCr, RGB, and CMYK and YCCK inverted, as Adobe writes them (without
/// their profile, so that colours are approximate). The size is checked against limits::kImageSide
/// and kTexels, and memory is charged before it is allocated. A file that ends early is an error;
/// the rest is not filled with gray. Errors: bad_input, limit, out_of_memory, without a place.
Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::codecs
