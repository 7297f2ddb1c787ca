#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codecs/image_file.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// Decodes a JPEG for a texture: gray, YCbCr, RGB, and CMYK and YCCK inverted, as Adobe writes them
/// (without their profile, so that colours are approximate). The size is checked against
/// limits::kImageSide and kTexels, and memory is charged before it is allocated. A file that ends
/// early is an error; the missing part is not filled with gray. Errors: bad_input, limit,
/// out_of_memory, without a place.
Result<RgbaImage> decode_jpeg(Context& context, std::span<const std::uint8_t> bytes);

/// Holds a JPEG's pixels and its information about colours and orientation.
struct JpegPhoto {
  Image image;                        ///< rgb8; if is_cmyk is set, rgba8 with the inks as channels
  bool is_gray = false;               ///< all three channels are the same
  bool is_cmyk = false;               ///< cyan, magenta, yellow and black
  bool is_inverted = false;           ///< inks as Adobe writes them: 255 is no ink
  bool has_profile = false;           ///< the file has parts of a profile, complete or not
  std::vector<std::uint8_t> profile;  ///< ICC; empty: none, or incomplete
  std::vector<std::uint8_t> exif;     ///< with kExifName; empty: none
};

/// Decodes a JPEG as decode_jpeg() does, but keeps inks as they are, and returns the information
/// about the pixels.
Result<JpegPhoto> decode_jpeg_photo(Context& context, std::span<const std::uint8_t> bytes);

/// Converts a pixel of four inks to sRGB, by a formula without a profile.
inline void rgb_of_inks(const std::uint8_t* inks, bool is_inverted, std::uint8_t* rgb) {
  const auto ink_free = [is_inverted](std::uint8_t byte) {
    return static_cast<unsigned>(is_inverted ? byte : 255 - byte);
  };
  const unsigned light = ink_free(inks[3]);
  for (int c = 0; c < 3; ++c) {
    rgb[c] = static_cast<std::uint8_t>((ink_free(inks[c]) * light + 127) / 255);
  }
}

}  // namespace sfumato::codecs
