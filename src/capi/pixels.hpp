#pragma once

#include <optional>

#include "sfumato/base/image.hpp"
#include "sfumato/sfumato.h"

namespace sfumato::capi {

/// What is said where format_of() finds none.
inline constexpr const char* kNoImage =
    "no image: a NULL, a size, a format, or rows that are too short";

/// The format of the caller's pixels. None: they are no image, by a NULL, a size, a format, or rows
/// that are shorter than their pixels or end beyond all memory.
std::optional<PixelFormat> format_of(const sfumato_image* image);

/// Bytes of a row's pixels.
std::size_t row_pixel_bytes(PixelFormat format, std::int32_t width);

}  // namespace sfumato::capi
