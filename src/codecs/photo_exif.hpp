#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::codecs {

/// What EXIF data begin with in a JPEG, and in some WebP files.
inline constexpr std::string_view kExifName("Exif\0\0", 6);

/// How a picture is to be turned to stand upright: 1 to 8 as EXIF counts them. 1 stands already, 2
/// to 4 keep the sides, 5 to 8 swap width and height.
using Orientation = int;

/// The orientation in EXIF data, which begin with the mark of their byte order, or with kExifName
/// before it. 1 where the data say none; no value where they are damaged.
std::optional<Orientation> exif_orientation(std::span<const std::uint8_t> exif);

/// Turns and mirrors an image so that it stands upright. Meanwhile both images are charged.
/// Errors: limit (memory), cancelled.
Status stand_upright(const Context& context, Orientation orientation, Image& image);

}  // namespace sfumato::codecs
