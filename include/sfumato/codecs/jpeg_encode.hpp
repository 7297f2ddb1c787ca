#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Encodes an rgb8 image as JPEG: progressive JFIF, which programs show as sRGB. Colour is kept at
/// full resolution, because these pictures have sharp edges between colours of equal lightness.
/// `quality` is from 1 to 100, on the scale of libjpeg. Use it for programs without WebP; it has no
/// alpha.
///
/// Errors: bad_input (a format other than rgb8, a size that disagrees with the bytes, a quality out
/// of range), limit, out_of_memory, cancelled.
/// Cost: O(pixels), in the calling thread.
Result<std::vector<std::uint8_t>> encode_jpeg(Context& context, const Image& image, int quality);

}  // namespace sfumato
