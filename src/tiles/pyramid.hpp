#pragma once

#include <cstddef>
#include <cstdint>

#include "base/pixel_rect.hpp"

namespace sfumato::tiles {

/// Holds the sizes of an image pyramid as Deep Zoom counts them: level 0 has one pixel, and each
/// level has twice as many pixels on a side as the level before, rounded up. The last level is the
/// whole image.
struct Pyramid {
  int width = 0;  ///< pixels of the last level
  int height = 0;
  int tile_side = 256;
  int overlap = 0;  ///< pixels by which a tile reaches into its neighbours

  int level_count() const;
  int level_width(int level) const;
  int level_height(int level) const;
  int columns(int level) const;  ///< of tiles
  int rows(int level) const;
  /// Returns a tile's pixels in its level, with the overlap.
  PixelRect tile(int level, int column, int row) const;
};

/// Neighbouring tiles of one level that are painted together.
struct TileBlock {
  int level = 0;
  int column0 = 0, row0 = 0;  ///< the first tile
  int columns = 0, rows = 0;

  std::size_t tile_count() const { return static_cast<std::size_t>(columns) * rows; }
};

/// Returns the tiles on a side of a block. A block is small enough for memory and large enough that
/// the fixed cost of painting it does not count.
int block_tiles(const Pyramid& pyramid);

/// Returns the number of blocks of all levels; the largest level comes first.
std::uint64_t block_count(const Pyramid& pyramid);

/// Returns block `index` of block_count().
TileBlock block_at(const Pyramid& pyramid, std::uint64_t index);

/// Returns the pixels of the level that the tiles of a block show.
PixelRect block_pixels(const Pyramid& pyramid, const TileBlock& block);

}  // namespace sfumato::tiles
