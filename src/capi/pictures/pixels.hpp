#pragma once

#include <optional>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/sfumato.h"

namespace sfumato::capi {

/// The error message if format_of() returns none.
inline constexpr const char* kNoImage =
    "no image: a NULL, a size, a format, or rows that are too short";

/// Returns the format of the caller's pixels. None: they are not an image, because of a NULL, a
/// size, a format, or rows that are shorter than their pixels or end beyond all memory.
std::optional<PixelFormat> format_of(const sfumato_image* image);

/// Returns the bytes of a row's pixels.
std::size_t row_pixel_bytes(PixelFormat format, std::int32_t width);

/// Copies the caller's pixels, row after row. Errors: limit (memory), cancelled.
Result<Image> copy_image(const Context& context, const sfumato_image& from, PixelFormat format,
                         TableMemory& memory);

}  // namespace sfumato::capi
