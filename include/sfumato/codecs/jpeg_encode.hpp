#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Encodes an rgb8 image as JPEG (JFIF, which means sRGB to whoever shows it; progressive; colour
/// at full resolution, since these pictures have sharp edges of equal lightness).
/// quality  1 to 100, the scale of libjpeg.
/// Errors: bad_input (another format than rgb8, bytes that are not the size's, another quality),
/// limit, out_of_memory, cancelled.
Result<std::vector<std::uint8_t>> encode_jpeg(Context& context, const Image& image, int quality);

}  // namespace sfumato
