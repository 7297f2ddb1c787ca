#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Holds a WebP's pixels and its information about colours and orientation.
struct WebpPhoto {
  Image image;                        ///< rgb8, or rgba8 if the file declares alpha
  std::vector<std::uint8_t> profile;  ///< ICC; empty: none
  std::vector<std::uint8_t> exif;     ///< empty: none
};

/// Decodes a WebP, lossy or lossless. The size is checked, and memory charged, before anything is
/// allocated. Between two polls of the cancel flag libwebp decodes one piece: docs/limits.md.
/// Errors: bad_input (damaged, cut short, an animation), limit, cancelled, out_of_memory, without a
/// place.
Result<WebpPhoto> decode_webp_photo(Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::codecs
