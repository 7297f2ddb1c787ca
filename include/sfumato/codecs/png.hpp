#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato {

/// Encodes an image as PNG with an sRGB chunk and no time stamp: the same image gives the same
/// bytes for any thread count. Use it for exact pixels, and for 16 bits per channel.
///
/// Errors: bad_input (a size that disagrees with the bytes), limit, cancelled, out_of_memory.
/// Cost: O(pixels), in stripes that the context's threads share.
Result<std::vector<std::uint8_t>> encode_png(Context& context, const Image& image);

/// Decodes any PNG: with 16 bits per channel where the file has 16, with alpha where the file has
/// transparency, greys and palettes as colours. The header is checked before memory is taken.
/// `file` names the input in messages.
///
/// Errors: bad_input (damaged, or cut short), limit (size, memory), cancelled, out_of_memory. Where
/// zlib is refused memory the error is bad_input, because libspng reports that as damage.
/// Cost: O(pixels), in the calling thread.
Result<Image> decode_png(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file);

/// Does decode_png(), but always with alpha: rgba8 or rgba16.
Result<Image> decode_png_with_alpha(Context& context, std::span<const std::uint8_t> bytes,
                                    const std::string& file);

}  // namespace sfumato
