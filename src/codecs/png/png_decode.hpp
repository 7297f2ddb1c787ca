#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::codecs {

/// Holds a PNG's pixels, as decode_png() returns them, and its information about colours and
/// orientation.
struct PngPhoto {
  Image image;
  int width = 0;  ///< of the file
  int height = 0;
  bool is_gray = false;                       ///< all three channels are the same
  bool is_srgb = false;                       ///< the file says so
  std::optional<double> gamma;                ///< gAMA: code value = light to this power
  std::optional<std::array<Vec2, 4>> chroma;  ///< cHRM: x and y of white, red, green and blue
  std::vector<std::uint8_t> profile;          ///< ICC; empty: none, or libspng refuses it
  bool has_profile = false;                   ///< the file has a profile, valid or not
  std::vector<std::uint8_t> exif;             ///< from its byte order mark; empty: none
};

/// The condition for shrinking a picture while it is read.
struct PhotoShrink {
  int side = 0;                 ///< its longer side then; 0: never
  std::size_t whole_bytes = 0;  ///< if it would take more than this many bytes
};

/// Errors and cost: as decode_png().
Result<PngPhoto> decode_png_photo(Context& context, std::span<const std::uint8_t> bytes,
                                  const std::string& file, const PhotoShrink& shrink = {});

}  // namespace sfumato::codecs
