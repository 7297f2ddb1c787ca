#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "raster/kernels/pixel_mask.hpp"

namespace sfumato::raster {

/// Returns floor(x), at least low and at most high; 0 <= low.
inline int clamped_floor(double x, int low, int high) {
  const double lifted = x > low ? x : low;
  return static_cast<int>(lifted < high ? lifted : high);
}

/// Returns the pixels of a tile that a box meets; for a box beside the tile the nearest ones.
inline PixelRange pixels_in(const Box& box, const Tile& tile) {
  const int last_x = tile.width - 1, last_y = tile.height - 1;
  return {clamped_floor(box.min.x - tile.x0, 0, last_x),
          clamped_floor(box.max.x - tile.x0, 0, last_x) + 1,
          clamped_floor(box.min.y - tile.y0, 0, last_y),
          clamped_floor(box.max.y - tile.y0, 0, last_y) + 1};
}

/// Returns whether the box lies in the pixel (x, y) of the image.
inline bool is_in_pixel(const Box& box, int x, int y) {
  return box.min.x >= x && box.max.x <= x + 1 && box.min.y >= y && box.max.y <= y + 1;
}

Box box_of(std::span<const Vec2> points);

/// The pixels of a tile that are marked, and their numbers, row by row.
class PixelMarks {
 public:
  void clear();
  /// Marks the pixels that an edge passes through.
  void mark_edge(Vec2 a, Vec2 b, const Tile& tile);
  /// Marks the pixels that the corners' convex hull touches.
  void mark_convex(std::span<const Vec2> corners, const Tile& tile);

  const PixelMask& mask() const { return mask_; }

  /// Numbers the marked pixels. Returns their number.
  std::uint32_t number();

  /// Calls visit(x, number) for the marked pixels of a row from begin up to but not including end.
  template <class Visit>
  void for_each(int row, int begin, int end, const Visit& visit) const {
    for (int i = begin / 64; i <= (end - 1) / 64; ++i) {
      std::uint64_t left = mask_.word[row][i] & columns_in_word(i, begin, end);
      for (; left != 0; left &= left - 1) {
        const int x = 64 * i + std::countr_zero(left);
        visit(x, std::uint32_t{number_[row][x]});
      }
    }
  }

 private:
  void mark_row(int row, int begin, int end);

  PixelMask mask_;
  std::uint16_t number_[kTileHeight][kTileWidth];  ///< only of marked pixels
  static_assert(kTileHeight * kTileWidth <= 1 << 16);
};

}  // namespace sfumato::raster
