#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// The name at the beginning of EXIF data in a JPEG and in some WebP files.
inline constexpr std::string_view kExifName("Exif\0\0", 6);

/// How to turn a picture upright: 1 to 8 as EXIF counts them. 1 is upright already, 2 to 4 keep the
/// sides, 5 to 8 swap width and height.
using Orientation = int;
inline constexpr Orientation kFirstSideways = 5;

/// Returns the orientation in EXIF data. The data begin with the mark of their byte order, or with
/// kExifName before it. The result is 1 if the data have no orientation, and no value if they are
/// damaged.
std::optional<Orientation> exif_orientation(std::span<const std::uint8_t> exif);

/// Turns and mirrors an image upright. Both images are charged meanwhile. Errors: limit (memory),
/// cancelled.
Status stand_upright(const Context& context, Orientation orientation, Image& image);

}  // namespace sfumato::codecs
