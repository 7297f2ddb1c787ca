#pragma once

#include <cstdint>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "tiles/pyramid.hpp"

namespace sfumato::tiles {

/// Holds the inputs of one file with a pyramid of tiles.
struct BigTiffOptions {
  Pyramid pyramid;       ///< without overlap; the side of a tile is a multiple of kTiffTileStep
  RasterOptions raster;  ///< the size of the pyramid; 8 bits a channel; no window
  std::string path;
};

/// Steps of a tile's side that the format allows, pixels.
inline constexpr int kTiffTileStep = 16;

/// Holds counts of the written file.
struct BigTiffStats {
  std::uint64_t tiles = 0;
  int levels = 0;
};

/// Writes a picture as a tiled BigTIFF, packed by Deflate with differences: the largest level
/// first, then smaller levels (NewSubfileType 1) down to the first level that fits in one tile.
/// Each level is painted at its own size. The file appears whole or not at all.
///
/// Errors: io, and as rasterize(). Memory: a block of about 2048 × 2048 pixels, and 16 bytes a tile
/// for libtiff.
Status write_big_tiff(Context& context, const Picture& picture, const BigTiffOptions& options,
                      BigTiffStats* stats);

}  // namespace sfumato::tiles
