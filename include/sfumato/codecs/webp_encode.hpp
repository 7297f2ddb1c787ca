#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Options of encode_webp().
struct WebpOptions {
  bool lossless = false;  ///< keep every byte, also the colours of pixels with alpha 0
  int quality = 90;       ///< 1 to 100, on the scale of libwebp; ignored where lossless
};

/// Longest side of a WebP image in pixels, a limit of the format.
inline constexpr int kWebpSide = 16'383;

/// Encodes an rgb8 or rgba8 image as WebP. Lossy files are smaller than JPEG, but have colour at
/// half resolution, which shows at sharp edges between colours.
///
/// Errors: bad_input (16 bits per channel, a size that disagrees with the bytes, a quality out of
/// range), limit (size, memory), out_of_memory, cancelled. libwebp does not always report memory
/// that it was refused (tests/allocation/README.md), and its passes over a large image can delay a
/// cancellation by seconds (docs/limits.md).
/// Cost: O(pixels). The context's threads share the conversion to YUV of lossy images; the passes
/// of libwebp run in the calling thread.
Result<std::vector<std::uint8_t>> encode_webp(Context& context, const Image& image,
                                              const WebpOptions& options);

}  // namespace sfumato
