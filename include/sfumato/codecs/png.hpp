#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Encodes as PNG (sRGB chunk, no time stamp: the same image gives the same bytes for any thread
/// count). Errors: bad_input (an image whose size and bytes disagree), limit, cancelled.
Result<std::vector<std::uint8_t>> encode_png(Context& context, const Image& image);

/// Decodes any PNG to rgb8, rgba8, rgb16 or rgba16. The header is checked before memory is taken.
/// Errors: bad_input, limit, out_of_memory; bad_input too where zlib is refused memory, which
/// libspng reports as damage.
Result<Image> decode_png(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file);

/// The same, to rgba8 or rgba16 whatever it holds.
Result<Image> decode_png_with_alpha(Context& context, std::span<const std::uint8_t> bytes,
                                    const std::string& file);

}  // namespace sfumato
