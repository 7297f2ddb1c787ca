#pragma once

#include "base/lane_register.hpp"
#include "raster/kernels/tile.hpp"

/// Sets of pixels of a tile. Compiled for every instruction set.
namespace sfumato::raster {

/// Pixels from a tile's upper left corner: bit x % 64 of word[row][x / 64].
struct PixelMask {
  static constexpr int kWords = kTileWidth / 64;
  static_assert(kTileWidth % 64 == 0);

  std::uint64_t word[kTileHeight][kWords];
};

/// Columns and rows of a tile, from its upper left corner; at least one pixel.
struct PixelRange {
  int begin, end, first_row, end_row;
};

inline namespace SFUMATO_ISA {

/// Returns the bits of word `index` for columns from `begin` up to but not including `end`; at
/// least one bit.
SFUMATO_INLINE std::uint64_t columns_in_word(int index, int begin, int end) {
  const int first = begin - 64 * index, last = end - 64 * index;
  return (~std::uint64_t{0} << (first > 0 ? first : 0)) &
         (~std::uint64_t{0} >> (last < 64 ? 64 - last : 0));
}

SFUMATO_INLINE bool holds_any(const PixelMask& mask, const PixelRange& range) {
  for (int i = range.begin / 64; i <= (range.end - 1) / 64; ++i) {
    const std::uint64_t columns = columns_in_word(i, range.begin, range.end);
    for (int row = range.first_row; row < range.end_row; ++row)
      if (mask.word[row][i] & columns) return true;
  }
  return false;
}

SFUMATO_INLINE bool holds_all(const PixelMask& mask, const PixelRange& range) {
  for (int i = range.begin / 64; i <= (range.end - 1) / 64; ++i) {
    const std::uint64_t columns = columns_in_word(i, range.begin, range.end);
    for (int row = range.first_row; row < range.end_row; ++row)
      if (~mask.word[row][i] & columns) return false;
  }
  return true;
}

}  // namespace SFUMATO_ISA
}  // namespace sfumato::raster
