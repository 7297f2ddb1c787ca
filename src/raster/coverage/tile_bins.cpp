#include "raster/coverage/tile_bins.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/poll.hpp"
#include "base/try.hpp"
#include "raster/coverage/triangle_blocks.hpp"
#include "raster/kernels/span_kernels.hpp"

namespace sfumato::raster {
namespace {

/// Returns the index of a tile; 0 where the pixel is NaN.
std::uint16_t tile_index(double pixel, int tile_side, int count) {
  const double tile = pixel / tile_side, last = count - 1;
  const double lifted = tile > 0 ? tile : 0;
  return static_cast<std::uint16_t>(lifted < last ? lifted : last);
}

std::uint16_t column_index(double x, const TileGrid& grid) {
  return tile_index(x - 1.0 * grid.first_column() * kTileWidth, kTileWidth, grid.columns());
}

std::uint16_t row_index(double y, const TileGrid& grid) {
  return tile_index(y - 1.0 * grid.first_row() * kTileHeight, kTileHeight, grid.rows());
}

/// Lists triangles of one layer by tile.
class Binner {
 public:
  Binner(const LayerView& layer, const TileGrid& grid, double margin_px)
      : layer_(layer), grid_(grid), margin_px_(margin_px) {}

  /// Finds the tiles that a triangle may touch, ranges[t], for triangles from `begin` up to but not
  /// including `end`.
  void find_ranges(const SpanKernels& kernels, std::size_t begin, std::size_t end,
                   TileRange* ranges) const;

  /// Does a counting sort by tile; `ranges` as in find_ranges().
  Status sort(Context& context, const std::vector<TileRange>& ranges, TileBins* bins) const;

 private:
  Vec2 corner(std::uint32_t triangle, int k) const {
    const std::uint32_t vertex = layer_.triangle_vertex[std::size_t{3} * triangle + k];
    return layer_.image_from_layer(layer_.vertex_position[vertex]);
  }
  TileRange range_in_row(std::uint32_t triangle, const TileRange& whole, int tile_row) const;

  template <class Visit>
  void for_each_tile(std::uint32_t triangle, const TileRange& range, const Visit& visit) const;

  const LayerView& layer_;
  const TileGrid& grid_;
  double margin_px_;
};

void Binner::find_ranges(const SpanKernels& kernels, std::size_t begin, std::size_t end,
                         TileRange* ranges) const {
  PlacedTriangles placed;
  std::uint32_t triangle[PlacedTriangles::kMost];
  for (std::size_t first = begin; first < end; first += PlacedTriangles::kMost) {
    const std::size_t count = std::min(end - first, PlacedTriangles::kMost);
    for (std::size_t i = 0; i < count; ++i) triangle[i] = static_cast<std::uint32_t>(first + i);
    kernels.place_triangles(layer_, triangle, count, Tile{}, &placed);
    for (std::size_t i = 0; i < count; ++i) {
      const Box box{{placed.left[i], placed.top[i]}, {placed.right[i], placed.bottom[i]}};
      ranges[first + i] = tiles_of(box.grown_by(margin_px_), grid_);
    }
  }
}

/// Returns the columns of tiles that a long triangle may touch in one row of tiles: a needle across
/// the image is listed along its length, not all over its bounding box.
TileRange Binner::range_in_row(std::uint32_t triangle, const TileRange& whole, int tile_row) const {
  constexpr double kSlackPx = 1;  // for rounding
  const double margin_px = margin_px_ + kSlackPx;
  const int image_row = grid_.first_row() + tile_row;
  const double top = 1.0 * image_row * kTileHeight - margin_px;
  const double bottom = (image_row + 1.0) * kTileHeight + margin_px;
  Box box;
  for (int k = 0; k < 3; ++k) {
    Vec2 a = corner(triangle, k);
    Vec2 b = corner(triangle, (k + 1) % 3);
    if (std::max(std::fabs(a.x), std::fabs(a.y)) > kExactBelowPx) return whole;
    if (a.y > b.y) std::swap(a, b);
    if (b.y < top || a.y > bottom) continue;
    box.extend(a.y < top ? lerp(a, b, (top - a.y) / (b.y - a.y)) : a);
    box.extend(b.y > bottom ? lerp(a, b, (bottom - a.y) / (b.y - a.y)) : b);
  }
  if (box.empty()) return {};
  TileRange range = whole;
  range.x0 = std::max(whole.x0, column_index(box.min.x - margin_px, grid_));
  range.x1 = std::min<std::uint16_t>(
      whole.x1, static_cast<std::uint16_t>(column_index(box.max.x + margin_px, grid_) + 1));
  return range;
}

template <class Visit>
void Binner::for_each_tile(std::uint32_t triangle, const TileRange& range,
                           const Visit& visit) const {
  const auto columns = static_cast<std::size_t>(grid_.columns());
  if (range.count() == 1) return visit(range.y0 * columns + range.x0);
  const bool is_long = range.y1 - range.y0 > 1 && range.x1 - range.x0 > 1;
  for (int y = range.y0; y < range.y1; ++y) {
    const TileRange row = is_long ? range_in_row(triangle, range, y) : range;
    for (int x = row.x0; x < row.x1; ++x) visit(static_cast<std::size_t>(y) * columns + x);
  }
}

Status Binner::sort(Context& context, const std::vector<TileRange>& ranges, TileBins* bins) const {
  const std::uint32_t triangle_count = static_cast<std::uint32_t>(ranges.size());
  SFUMATO_TRY(bins->memory.resize(context, bins->first, grid_.tile_count() + 1));
  RarePoll<16384> poll(context);
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    if (poll.cancelled()) return context.cancel_status();
    for_each_tile(t, ranges[t], [&](std::size_t tile) { ++bins->first[tile + 1]; });
  }
  if (context.cancelled()) return context.cancel_status();
  for (std::size_t i = 1; i < bins->first.size(); ++i) bins->first[i] += bins->first[i - 1];

  TableMemory next_memory("lists of triangles");
  std::vector<std::uint64_t> next;
  SFUMATO_TRY(bins->memory.resize(context, bins->triangle, bins->first.back()));
  SFUMATO_TRY(next_memory.append(context, bins->first, next));
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    if (poll.cancelled()) return context.cancel_status();
    for_each_tile(t, ranges[t], [&](std::size_t tile) { bins->triangle[next[tile]++] = t; });
  }
  return context.check();
}

}  // namespace

PixelRect tile_rect(const TileGrid& grid, std::size_t tile) {
  const std::size_t columns = static_cast<std::size_t>(grid.columns());
  const int x0 = (grid.first_column() + static_cast<int>(tile % columns)) * kTileWidth;
  const int y0 = (grid.first_row() + static_cast<int>(tile / columns)) * kTileHeight;
  return {x0, y0, std::min(x0 + kTileWidth, grid.width), std::min(y0 + kTileHeight, grid.height)};
}

TileRange tiles_of(const Box& box_px, const TileGrid& grid) {
  if (grid.tile_count() == 0) return {};
  const PixelRect first = tile_rect(grid, 0), last = tile_rect(grid, grid.tile_count() - 1);
  const Box tiles{{1.0 * first.x0, 1.0 * first.y0}, {1.0 * last.x1, 1.0 * last.y1}};
  if (!overlap(box_px, tiles)) return {};
  TileRange range;
  range.x0 = column_index(box_px.min.x, grid);
  range.y0 = row_index(box_px.min.y, grid);
  range.x1 = static_cast<std::uint16_t>(column_index(box_px.max.x, grid) + 1);
  range.y1 = static_cast<std::uint16_t>(row_index(box_px.max.y, grid) + 1);
  return range;
}

Result<TileBins> bin_triangles(Context& context, const LayerView& layer,
                               std::uint32_t triangle_count, const TileGrid& grid,
                               double margin_px) {
  TableMemory range_memory("places of triangles");
  std::vector<TileRange> ranges;
  SFUMATO_TRY(range_memory.resize(context, ranges, triangle_count));
  const Binner binner(layer, grid, margin_px);
  const SpanKernels& kernels = span_kernels(context.simd);
  constexpr std::size_t kGrain = 4096;
  SFUMATO_TRY(
      parallel_for(context, triangle_count, kGrain, [&](std::size_t begin, std::size_t end) {
        binner.find_ranges(kernels, begin, end, ranges.data());
      }));
  TileBins bins;
  SFUMATO_TRY(binner.sort(context, ranges, &bins));
  return bins;
}

}  // namespace sfumato::raster
