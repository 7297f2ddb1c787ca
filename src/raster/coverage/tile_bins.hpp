#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "raster/kernels/tile.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::raster {

/// The tiles of an image that a window meets, row by row. Tiles are cut from the image's corner.
struct TileGrid {
  int width = 0;  ///< of the image, pixels
  int height = 0;
  PixelRect window{0, 0, width, height};

  int first_column() const { return window.x0 / kTileWidth; }  ///< in columns of the image's tiles
  int first_row() const { return window.y0 / kTileHeight; }
  int columns() const { return (window.x1 + kTileWidth - 1) / kTileWidth - first_column(); }
  int rows() const { return (window.y1 + kTileHeight - 1) / kTileHeight - first_row(); }
  std::size_t tile_count() const { return static_cast<std::size_t>(columns()) * rows(); }
};

/// Returns the pixels of a tile, also the pixels outside the window.
PixelRect tile_rect(const TileGrid& grid, std::size_t tile);

/// The tiles from (x0, y0) up to but not including (x1, y1); empty where x0 == x1.
struct TileRange {
  std::uint16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 == x1; }
  std::size_t count() const { return static_cast<std::size_t>(x1 - x0) * (y1 - y0); }
};

/// Returns the tiles that a box in pixels meets.
TileRange tiles_of(const Box& box_px, const TileGrid& grid);

/// For each tile the triangles of one layer that may touch it.
struct TileBins {
  std::vector<std::uint64_t> first;  ///< tile_count + 1 offsets into `triangle`
  std::vector<std::uint32_t> triangle;
  TableMemory memory{"lists of triangles"};

  TriangleList of(std::size_t tile) const {
    return {triangle.data() + first[tile], static_cast<std::size_t>(first[tile + 1] - first[tile])};
  }
};

/// Sorts the triangles whose bounding box, grown by margin_px, meets the image into tiles; a
/// counting sort, so that each tile's list is increasing. Memory: 8 bytes per triangle during the
/// sort, 4 bytes per listed triangle in the result. Errors: limit, cancelled.
Result<TileBins> bin_triangles(Context& context, const LayerView& layer,
                               std::uint32_t triangle_count, const TileGrid& grid,
                               double margin_px);

}  // namespace sfumato::raster
