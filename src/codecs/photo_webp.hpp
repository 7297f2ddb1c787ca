#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// A WebP's pixels, and what it says about their colours and its orientation.
struct WebpPhoto {
  Image image;                        ///< rgb8, or rgba8 where the file says it has alpha
  std::vector<std::uint8_t> profile;  ///< ICC; empty: none
  std::vector<std::uint8_t> exif;     ///< empty: none
};

/// Decodes a WebP, lossy or lossless. The size is checked, and memory charged, before anything is
/// allocated. libwebp decodes what one look at the cancel flag lets pass: docs/limits.md.
/// Errors: bad_input (damaged, cut short, an animation), limit, cancelled, out_of_memory, without a
/// place.
Result<WebpPhoto> decode_webp_photo(Context& context, std::span<const std::uint8_t> bytes);

}  // namespace sfumato::codecs
