#pragma once

#include <optional>

#include "raster/coverage/tile_bins.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::raster {

/// Checks the size of the image against limits.hpp, its window, its format and its background.
/// Errors: bad_input, limit.
Status check_options(const Limits& limits, const RasterOptions& options);

/// Checks the options of an image that is painted in windows.
Status check_whole(const RasterOptions& options);

/// Returns the size of the larger image, and its painted pixels. The options were checked.
TileGrid grid_of(const RasterOptions& options);

/// The value of a pixel where nothing is painted.
struct Backdrop {
  Rgb color;
  float alpha = 1;
};

/// Returns the options' background, else the document's, else white or, in formats with alpha,
/// transparent.
Backdrop choose_backdrop(const RasterOptions& options, const std::optional<Rgb>& document);

}  // namespace sfumato::raster
