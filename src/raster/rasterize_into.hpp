#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/base/color.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::raster {

/// rasterize() with `own_background` in the place of Picture::background.
Result<Image> rasterize_on(Context& context, const Picture& picture, const RasterOptions& options,
                           const std::optional<Rgb>& own_background);

/// The same into memory of the caller's: RasterOptions::height rows from `bytes` on, `row_bytes`
/// apart, which are at least Image::row_bytes(). What lies between rows is not touched; after an
/// error the pixels are unspecified.
Status rasterize_into(Context& context, const Picture& picture, const RasterOptions& options,
                      const std::optional<Rgb>& own_background, std::uint8_t* bytes,
                      std::size_t row_bytes);

}  // namespace sfumato::raster
