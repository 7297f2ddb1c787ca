#include "tiles/pyramid.hpp"

#include <algorithm>

namespace sfumato::tiles {
namespace {

/// The approximate side of a block, pixels.
constexpr int kBlockSide = 2048;

constexpr int rounded_up(int value, int divisor) {
  return static_cast<int>((static_cast<std::int64_t>(value) + divisor - 1) / divisor);
}

int halved(int side, int times) {
  return static_cast<int>((static_cast<std::int64_t>(side) + (std::int64_t{1} << times) - 1) >>
                          times);
}

std::uint64_t level_blocks(const Pyramid& pyramid, int level) {
  const int side = block_tiles(pyramid);
  return std::uint64_t{1} * static_cast<unsigned>(rounded_up(pyramid.columns(level), side)) *
         static_cast<unsigned>(rounded_up(pyramid.rows(level), side));
}

}  // namespace

int Pyramid::level_count() const {
  int last = 0;
  while ((std::int64_t{1} << last) < std::max(width, height)) ++last;
  return last + 1;
}

int Pyramid::level_width(int level) const {
  return halved(width, level_count() - 1 - level);
}

int Pyramid::level_height(int level) const {
  return halved(height, level_count() - 1 - level);
}

int Pyramid::columns(int level) const {
  return rounded_up(level_width(level), tile_side);
}

int Pyramid::rows(int level) const {
  return rounded_up(level_height(level), tile_side);
}

PixelRect Pyramid::tile(int level, int column, int row) const {
  const int x = column * tile_side, y = row * tile_side;
  return {std::max(x - overlap, 0), std::max(y - overlap, 0),
          std::min(x + tile_side + overlap, level_width(level)),
          std::min(y + tile_side + overlap, level_height(level))};
}

int block_tiles(const Pyramid& pyramid) {
  return std::max(1, kBlockSide / pyramid.tile_side);
}

std::uint64_t block_count(const Pyramid& pyramid) {
  std::uint64_t count = 0;
  for (int level = 0; level < pyramid.level_count(); ++level) count += level_blocks(pyramid, level);
  return count;
}

TileBlock block_at(const Pyramid& pyramid, std::uint64_t index) {
  TileBlock block;
  block.level = pyramid.level_count() - 1;
  while (index >= level_blocks(pyramid, block.level)) {
    index -= level_blocks(pyramid, block.level);
    --block.level;
  }
  const int side = block_tiles(pyramid);
  const int across = rounded_up(pyramid.columns(block.level), side);
  block.column0 = side * static_cast<int>(index % static_cast<unsigned>(across));
  block.row0 = side * static_cast<int>(index / static_cast<unsigned>(across));
  block.columns = std::min(side, pyramid.columns(block.level) - block.column0);
  block.rows = std::min(side, pyramid.rows(block.level) - block.row0);
  return block;
}

PixelRect block_pixels(const Pyramid& pyramid, const TileBlock& block) {
  return united(
      pyramid.tile(block.level, block.column0, block.row0),
      pyramid.tile(block.level, block.column0 + block.columns - 1, block.row0 + block.rows - 1));
}

}  // namespace sfumato::tiles
