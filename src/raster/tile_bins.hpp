#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/status.hpp"
#include "raster/tile.hpp"

namespace sfumato::raster {

/// The image cut into tiles, row by row.
struct TileGrid {
  int width = 0;  ///< pixels
  int height = 0;

  int columns() const { return (width + kTileWidth - 1) / kTileWidth; }
  int rows() const { return (height + kTileHeight - 1) / kTileHeight; }
  std::size_t tile_count() const { return static_cast<std::size_t>(columns()) * rows(); }
};

/// For each tile the triangles of one layer that may touch it.
struct TileBins {
  std::vector<std::uint64_t> first;  ///< tile_count + 1 offsets into `triangle`
  std::vector<std::uint32_t> triangle;
  ScopedCharge charge;

  TriangleList of(std::size_t tile) const {
    return {triangle.data() + first[tile], static_cast<std::size_t>(first[tile + 1] - first[tile])};
  }
};

/// Sorts the triangles whose bounding box, grown by margin_px, meets the image into tiles; a
/// counting sort, so that each tile's list is increasing. 8 bytes a triangle while it runs, 4 bytes
/// a listed triangle to keep. Errors: limit, cancelled.
Result<TileBins> bin_triangles(Context& context, const LayerView& layer,
                               std::uint32_t triangle_count, const TileGrid& grid,
                               double margin_px);

}  // namespace sfumato::raster
