#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Reads a picture as people see it: a PNG, a JPEG or a WebP, whichever its first bytes show,
/// upright as its EXIF data say, its colours converted to sRGB.
///
/// - 16 bits where the file has them, alpha where it has transparency; gray and palettes as
/// colours.
/// - Colours: by the ICC profile, relative colorimetric with black point compensation; in a PNG
///   without one, and without sRGB, by gAMA and cHRM; else they are sRGB. A profile that changes no
///   colour by more than half a code value of 8 bits is left out. CMYK without a profile is
///   converted by a formula.
/// - What is damaged of all this is ignored, with a warning; damaged pixels are an error.
///
/// file      names the input in messages
/// warnings  what was ignored is appended; may be null
/// Errors: bad_input (damaged, cut short, of another kind), limit (a side, texels, memory),
/// cancelled, out_of_memory.
/// Cost: O(pixels); the conversion of colours is shared by the context's threads.
Result<Image> read_photo(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file, std::vector<Diagnostic>* warnings = nullptr);

}  // namespace sfumato::codecs
