#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Reads a picture as people see it: a PNG, a JPEG or a WebP (its first bytes decide which),
/// upright by its EXIF data, with colours converted to sRGB.
///
/// - 16 bits if the file has them, alpha if it has transparency; gray and palettes become colours.
/// - Colours: converted by the ICC profile, relative colorimetric with black point compensation. A
///   PNG without a profile and without sRGB is converted by gAMA and cHRM. All others are sRGB. A
///   profile that changes no colour by more than half a code value of 8 bits is left out. CMYK
///   without a profile is converted by a formula.
/// - Damaged profiles and orientations are ignored, with a warning; damaged pixels are an error.
///
/// file: names the input in messages. warnings: parts that were ignored are appended; may be null.
/// Errors: bad_input (damaged, cut short, of another kind), limit (a side, texels, memory),
/// cancelled, out_of_memory. Cost: O(pixels); the context's threads share the conversion of
/// colours.
Result<Image> read_photo(Context& context, std::span<const std::uint8_t> bytes,
                         const std::string& file, std::vector<Diagnostic>* warnings = nullptr);

/// Holds a picture, or a smaller version of it.
struct SizedPhoto {
  Image image;
  int width = 0;  ///< of the picture in its file, upright
  int height = 0;
};

/// A PNG that takes more bytes is not read as a whole if a smaller picture is enough.
inline constexpr std::size_t kWholePhotoBytes = std::size_t{64} << 20;

/// Reads a photo like read_photo(), for work that needs at most `max_side` pixels on the longer
/// side. A PNG of more than kWholePhotoBytes is shrunk to that size, with 16 bits, while it is
/// read. Pixels are averaged in the file's code values. Errors and cost: as read_photo().
Result<SizedPhoto> read_sized_photo(Context& context, std::span<const std::uint8_t> bytes,
                                    const std::string& file, int max_side,
                                    std::vector<Diagnostic>* warnings = nullptr);

}  // namespace sfumato::codecs
