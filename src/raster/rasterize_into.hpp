#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/base/color.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::raster {

/// Does rasterize() with `own_background` instead of Picture::background.
Result<Image> rasterize_on(Context& context, const Picture& picture, const RasterOptions& options,
                           const std::optional<Rgb>& own_background);

/// Does rasterize_into() with the same.
Status rasterize_into_on(Context& context, const Picture& picture, const RasterOptions& options,
                         const std::optional<Rgb>& own_background, std::uint8_t* pixels,
                         std::size_t row_bytes);

}  // namespace sfumato::raster
