#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

struct WebpOptions {
  bool lossless = false;
  int quality = 90;  ///< of what is not lossless: 1 to 100
};

/// Longest side of a WebP image, pixels: the format's own limit.
inline constexpr int kWebpSide = 16'383;

/// Encodes an rgb8 or rgba8 image as WebP. Lossless keeps every byte, also colours where alpha is
/// 0. Errors: bad_input (16 bits per channel, bytes that are not the size's, another quality),
/// limit (size, memory), out_of_memory, cancelled. Of memory that libwebp is refused it does not
/// always tell (tests/allocation/README.md).
Result<std::vector<std::uint8_t>> encode_webp(Context& context, const Image& image,
                                              const WebpOptions& options);

}  // namespace sfumato
