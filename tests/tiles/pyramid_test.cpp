#include "tiles/pyramid.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace sfumato::tiles {
namespace {

struct Size {
  int width, height, tile_side, overlap;
};

constexpr Size kSizes[] = {{1, 1, 256, 0},     {256, 256, 256, 0},   {257, 1, 256, 1},
                           {1000, 700, 64, 0}, {1000, 700, 64, 5},   {5000, 4097, 254, 1},
                           {3, 9000, 16, 2},   {4096, 4096, 4096, 0}};

TEST(Pyramid, halves_rounded_up_to_one_pixel) {
  const Pyramid pyramid{1000, 700};
  EXPECT_EQ(pyramid.level_count(), 11);
  EXPECT_EQ(pyramid.level_width(10), 1000);
  EXPECT_EQ(pyramid.level_height(9), 350);
  EXPECT_EQ(pyramid.level_height(8), 175);
  EXPECT_EQ(pyramid.level_height(7), 88);
  EXPECT_EQ(pyramid.level_width(0), 1);
  EXPECT_EQ(pyramid.level_height(0), 1);
  EXPECT_EQ((Pyramid{1, 1}.level_count()), 1);
  EXPECT_EQ((Pyramid{1 << 24, 3}.level_count()), 25);
  EXPECT_EQ((Pyramid{(1 << 24) - 1, 3}.level_width(0)), 1);
}

TEST(Pyramid, blocks_hold_every_tile_once_and_tiles_every_pixel) {
  for (const Size& size : kSizes) {
    const Pyramid pyramid{size.width, size.height, size.tile_side, size.overlap};
    std::map<std::tuple<int, int, int>, int> held;
    std::map<int, std::int64_t> pixels;
    int last_level = pyramid.level_count() - 1;
    for (std::uint64_t index = 0; index < block_count(pyramid); ++index) {
      const TileBlock block = block_at(pyramid, index);
      ASSERT_LE(block.level, last_level);
      last_level = block.level;
      const PixelRect whole = block_pixels(pyramid, block);
      for (int row = block.row0; row < block.row0 + block.rows; ++row) {
        for (int column = block.column0; column < block.column0 + block.columns; ++column) {
          ++held[{block.level, column, row}];
          const PixelRect tile = pyramid.tile(block.level, column, row);
          EXPECT_EQ(intersection(tile, whole), tile);
          const int x = column * size.tile_side, y = row * size.tile_side;
          EXPECT_GE(tile.x1 - x, 1);
          EXPECT_LE(tile.x1 - tile.x0, size.tile_side + 2 * size.overlap);
          EXPECT_EQ(tile.x0, std::max(x - size.overlap, 0));
          const PixelRect own = intersection(tile, {x, y, x + size.tile_side, y + size.tile_side});
          pixels[block.level] += std::int64_t{own.x1 - own.x0} * (own.y1 - own.y0);
        }
      }
    }
    EXPECT_EQ(last_level, 0);
    for (int level = 0; level < pyramid.level_count(); ++level) {
      EXPECT_EQ(pixels[level],
                std::int64_t{pyramid.level_width(level)} * pyramid.level_height(level));
    }
    for (const auto& [tile, count] : held) EXPECT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace sfumato::tiles
