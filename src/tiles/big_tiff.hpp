#pragma once

#include <cstdint>
#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "tiles/pyramid.hpp"

namespace sfumato::tiles {

/// What one file with a pyramid of tiles is made of.
struct BigTiffOptions {
  Pyramid pyramid;       ///< without overlap, tiles a multiple of kTiffTileStep on a side
  RasterOptions raster;  ///< the size is that of the pyramid; 8 bits a channel; no window
  std::string path;
};

/// Of the format.
inline constexpr int kTiffTileStep = 16;

/// What was written.
struct BigTiffStats {
  std::uint64_t tiles = 0;
  int levels = 0;
};

/// Writes a picture as a tiled BigTIFF, packed by Deflate with differences: the largest level
/// first, then reduced ones (NewSubfileType 1) down to the first that one tile holds, each painted
/// at its own size. The file appears whole or not at all.
///
/// Errors: io, those of rasterize().
/// Memory: a block of about 2048 × 2048 pixels, and what libtiff takes: 16 bytes a tile.
Status write_big_tiff(Context& context, const Picture& picture, const BigTiffOptions& options,
                      BigTiffStats* stats);

}  // namespace sfumato::tiles
