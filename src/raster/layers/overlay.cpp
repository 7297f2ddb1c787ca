#include "raster/layers/overlay.hpp"

#include <algorithm>
#include <cmath>

#include "base/segment.hpp"

namespace sfumato::raster {
namespace {

constexpr double kFreeHalfWidthPx = 0.4;
constexpr double kCurveHalfWidthPx = 0.9;
constexpr float kFreeOpacity = 0.4f;
constexpr float kCurveInk[3] = {1.0f, 0.42f, 0.05f};

Vec2 corner(const LayerView& layer, std::uint32_t triangle, int k) {
  const std::uint32_t vertex = layer.triangle_vertex[std::size_t{3} * triangle + k];
  return layer.image_from_layer(layer.vertex_position[vertex]);
}

/// The pixels of a row, from the tile's left, that may lie within reach of the segment.
struct Columns {
  int begin, end;
};

Columns columns_in_reach(Vec2 a, Vec2 b, double row_y, const Tile& tile) {
  double low = std::min(a.x, b.x);
  double high = std::max(a.x, b.x);
  if (a.y != b.y) {
    const double dx_dy = (b.x - a.x) / (b.y - a.y);
    const double x = a.x + (row_y - a.y) * dx_dy;
    // The line's distance is |x - px| / sqrt(1 + dx_dy^2).
    const double spread = kOverlayReachPx * std::sqrt(1 + dx_dy * dx_dy);
    low = std::max(low, x - spread);
    high = std::min(high, x + spread);
  }
  const double x0 = tile.x0;
  const double width = tile.width;
  return {static_cast<int>(std::clamp(low - kOverlayReachPx - x0, 0.0, width)),
          static_cast<int>(std::clamp(high + kOverlayReachPx + 1 - x0, 0.0, width))};
}

}  // namespace

void Overlay::clear() {
  free_.assign(kTileFloats, 0);
  curve_.assign(kTileFloats, 0);
}

void Overlay::add_edge(Vec2 a, Vec2 b, bool is_curve, const Tile& tile) {
  const double half_width = is_curve ? kCurveHalfWidthPx : kFreeHalfWidthPx;
  std::vector<float>& ink = is_curve ? curve_ : free_;
  const double top = std::min(a.y, b.y) - kOverlayReachPx - tile.y0;
  const double bottom = std::max(a.y, b.y) + kOverlayReachPx + 1 - tile.y0;
  const int first_row = static_cast<int>(std::clamp(top, 0.0, 1.0 * tile.height));
  const int end_row = static_cast<int>(std::clamp(bottom, 0.0, 1.0 * tile.height));
  for (int row = first_row; row < end_row; ++row) {
    const double y = tile.y0 + row + 0.5;
    const Columns columns = columns_in_reach(a, b, y, tile);
    for (int x = columns.begin; x < columns.end; ++x) {
      const Vec2 center{tile.x0 + x + 0.5, y};
      const double distance = length(center - nearest_on_segment(center, a, b));
      const double share = std::clamp(half_width + 0.5 - distance, 0.0, 1.0);
      float& pixel = ink[static_cast<std::size_t>(row) * kTileStride + x];
      pixel = std::max(pixel, static_cast<float>(share));
    }
  }
}

void Overlay::add(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  for (std::size_t i = 0; i < triangles.count; ++i) {
    const std::uint32_t t = triangles.triangle[i];
    for (int k = 0; k < 3; ++k) {
      const bool is_curve = layer.edge_is_curve[std::size_t{3} * t + k] != 0;
      add_edge(corner(layer, t, k), corner(layer, t, (k + 1) % 3), is_curve, tile);
    }
  }
}

void Overlay::paint(const Tile& tile) const {
  for (int row = 0; row < tile.height; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kTileStride;
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(tile.width); ++i) {
      const float luma =
          0.3f * tile.color[0][i] + 0.6f * tile.color[1][i] + 0.1f * tile.color[2][i];
      const float free_ink = luma < 0.5f ? 1.0f : 0.0f;
      for (int c = 0; c < 3; ++c) {
        float& value = tile.color[c][i];
        value += (free_ink - value) * (free_[i] * kFreeOpacity);
        value += (kCurveInk[c] - value) * curve_[i];
      }
      if (tile.alpha) tile.alpha[i] = std::max({tile.alpha[i], free_[i], curve_[i]});
    }
  }
}

}  // namespace sfumato::raster
