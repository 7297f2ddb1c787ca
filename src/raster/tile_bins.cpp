#include "raster/tile_bins.hpp"

#include <algorithm>
#include <cmath>

#include "base/box.hpp"

namespace sfumato::raster {
namespace {

/// The tiles from (x0, y0) up to but not (x1, y1); empty where x0 == x1.
struct TileRange {
  std::uint16_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

std::uint16_t tile_index(double pixel, int tile_side, int count) {
  return static_cast<std::uint16_t>(std::clamp(std::floor(pixel / tile_side), 0.0, count - 1.0));
}

TileRange tile_range(const LayerView& layer, std::uint32_t triangle, const TileGrid& grid,
                     double margin_px) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t vertex = layer.triangle_vertex[std::size_t{3} * triangle + k];
    box.extend(layer.image_from_layer(layer.vertex_position[vertex]));
  }
  box = box.grown_by(margin_px);
  const Box image{{0, 0}, {static_cast<double>(grid.width), static_cast<double>(grid.height)}};
  if (!overlap(box, image)) return {};
  TileRange range;
  range.x0 = tile_index(box.min.x, kTileWidth, grid.columns());
  range.y0 = tile_index(box.min.y, kTileHeight, grid.rows());
  range.x1 = static_cast<std::uint16_t>(tile_index(box.max.x, kTileWidth, grid.columns()) + 1);
  range.y1 = static_cast<std::uint16_t>(tile_index(box.max.y, kTileHeight, grid.rows()) + 1);
  return range;
}

template <class Visit>
void for_each_tile(const TileRange& range, const TileGrid& grid, const Visit& visit) {
  for (int y = range.y0; y < range.y1; ++y) {
    for (int x = range.x0; x < range.x1; ++x)
      visit(static_cast<std::size_t>(y) * grid.columns() + x);
  }
}

Status fill(Context& context, const std::vector<TileRange>& ranges, const TileGrid& grid,
            TileBins* bins) {
  Status status = bins->charge.add(context, (grid.tile_count() + 1) * 8, "lists of triangles");
  if (!status) return status;
  bins->first.assign(grid.tile_count() + 1, 0);
  for (const TileRange& range : ranges)
    for_each_tile(range, grid, [&](std::size_t tile) { ++bins->first[tile + 1]; });
  for (std::size_t i = 1; i < bins->first.size(); ++i) bins->first[i] += bins->first[i - 1];

  const std::uint64_t listed = bins->first.back();
  status = bins->charge.add(context, listed * 4 + grid.tile_count() * 8, "lists of triangles");
  if (!status) return status;
  bins->triangle.resize(listed);
  std::vector<std::uint64_t> next(bins->first.begin(), bins->first.end() - 1);
  for (std::uint32_t t = 0; t < ranges.size(); ++t)
    for_each_tile(ranges[t], grid, [&](std::size_t tile) { bins->triangle[next[tile]++] = t; });
  return status;
}

}  // namespace

Result<TileBins> bin_triangles(Context& context, const LayerView& layer,
                               std::uint32_t triangle_count, const TileGrid& grid,
                               double margin_px) {
  ScopedCharge range_charge;
  Status status = range_charge.add(context, std::size_t{triangle_count} * sizeof(TileRange),
                                   "places of triangles");
  if (!status) return status;
  std::vector<TileRange> ranges(triangle_count);
  constexpr std::size_t kGrain = 4096;
  status = parallel_for(context, triangle_count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      ranges[t] = tile_range(layer, static_cast<std::uint32_t>(t), grid, margin_px);
  });
  if (!status) return status;
  TileBins bins;
  status = fill(context, ranges, grid, &bins);
  if (!status) return status;
  return bins;
}

}  // namespace sfumato::raster
