#pragma once

#include <array>
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

/// A PNG's pixels, as decode_png() gives them, and what it says about their colours and its
/// orientation.
struct PngPhoto {
  Image image;
  bool is_gray = false;                       ///< all three channels are the same
  bool is_srgb = false;                       ///< the file says so
  std::optional<double> gamma;                ///< gAMA: code value = light to this power
  std::optional<std::array<Vec2, 4>> chroma;  ///< cHRM: x and y of white, red, green and blue
  std::vector<std::uint8_t> profile;          ///< ICC; empty: none, or one that libspng refuses
  bool has_profile = false;                   ///< the file has one, good or not
  std::vector<std::uint8_t> exif;             ///< from its byte order mark; empty: none
};

/// Errors and cost: as decode_png().
Result<PngPhoto> decode_png_photo(Context& context, std::span<const std::uint8_t> bytes,
                                  const std::string& file);

}  // namespace sfumato::codecs
