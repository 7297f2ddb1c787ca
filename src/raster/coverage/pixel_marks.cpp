#include "raster/coverage/pixel_marks.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace sfumato::raster {
namespace {

/// Calls visit(row, begin, end) for the pixels of the tile, from its corner, that an edge passes
/// through.
template <class Visit>
void for_each_row(Vec2 a, Vec2 b, const Tile& tile, const Visit& visit) {
  if (a.y > b.y) std::swap(a, b);
  const double x_low = std::min(a.x, b.x);
  const double x_high = std::max(a.x, b.x);
  const int last_x = tile.x0 + tile.width - 1;
  if (b.y < tile.y0 || a.y > tile.y0 + tile.height) return;
  if (x_high < tile.x0 || x_low > last_x + 1) return;
  const double dx_dy = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
  const int first_row = clamped_floor(a.y, tile.y0, tile.y0 + tile.height - 1);
  const int last_row = clamped_floor(b.y, tile.y0, tile.y0 + tile.height - 1);
  for (int y = first_row; y <= last_row; ++y) {
    // Where the edge enters and leaves the row; its ends where they lie in the row.
    const double x_in = a.y >= y ? a.x : a.x + (y - a.y) * dx_dy;
    const double x_out = b.y <= y + 1 ? b.x : a.x + (y + 1 - a.y) * dx_dy;
    const double left = std::clamp(std::min(x_in, x_out), x_low, x_high);
    const double right = std::clamp(std::max(x_in, x_out), x_low, x_high);
    if (right < tile.x0 || left > last_x + 1) continue;
    const int begin = clamped_floor(left, tile.x0, last_x) - tile.x0;
    const int end = clamped_floor(right, tile.x0, last_x) - tile.x0 + 1;
    visit(y - tile.y0, begin, end);
  }
}

}  // namespace

Box box_of(std::span<const Vec2> points) {
  Box box;
  for (Vec2 p : points) box.extend(p);
  return box;
}

void PixelMarks::clear() {
  std::memset(mask_.word, 0, sizeof(mask_.word));
}

void PixelMarks::mark_row(int row, int begin, int end) {
  for (int i = begin / 64; i <= (end - 1) / 64; ++i)
    mask_.word[row][i] |= columns_in_word(i, begin, end);
}

void PixelMarks::mark_edge(Vec2 a, Vec2 b, const Tile& tile) {
  for_each_row(a, b, tile, [&](int row, int begin, int end) { mark_row(row, begin, end); });
}

void PixelMarks::mark_convex(std::span<const Vec2> corners, const Tile& tile) {
  const Box box = box_of(corners);
  const PixelRange range = pixels_in(box, tile);
  if (is_in_pixel(box, tile.x0 + range.begin, tile.y0 + range.first_row))
    return mark_row(range.first_row, range.begin, range.begin + 1);
  int first[kTileHeight], last[kTileHeight];
  for (int row = range.first_row; row < range.end_row; ++row)
    first[row] = kTileWidth, last[row] = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for_each_row(corners[i], corners[i + 1 < corners.size() ? i + 1 : 0], tile,
                 [&](int row, int begin, int end) {
                   first[row] = std::min(first[row], begin);
                   last[row] = std::max(last[row], end);
                 });
  }
  for (int row = range.first_row; row < range.end_row; ++row)
    if (first[row] < last[row]) mark_row(row, first[row], last[row]);
}

std::uint32_t PixelMarks::number() {
  std::uint32_t count = 0;
  for (int row = 0; row < kTileHeight; ++row) {
    for (int i = 0; i < PixelMask::kWords; ++i) {
      for (std::uint64_t left = mask_.word[row][i]; left != 0; left &= left - 1)
        number_[row][64 * i + std::countr_zero(left)] = static_cast<std::uint16_t>(count++);
    }
  }
  return count;
}

}  // namespace sfumato::raster
