#include "raster/coverage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "raster/clip.hpp"
#include "raster/patch_polynomial.hpp"

namespace sfumato::raster {
namespace {

/// floor(x), at least low and at most high; 0 <= low.
int clamped_floor(double x, int low, int high) {
  return static_cast<int>(std::clamp(x, static_cast<double>(low), static_cast<double>(high)));
}

struct Corners {
  PixelPoint at[3];

  Vec2 vec(int k) const { return {at[k].x, at[k].y}; }
};

Corners corners_of(const LayerView& layer, std::uint32_t triangle) {
  Corners corners;
  for (int k = 0; k < 3; ++k) corners.at[k] = corner_position(layer, triangle, k);
  return corners;
}

/// A triangle that mixed pixels are made of.
struct MixedTriangle {
  ClipTriangle clip;
  TriangleFrame frame;
  PatchPolynomial patch;

  MixedTriangle(const LayerView& layer, std::uint32_t triangle, const Corners& c)
      : clip(layer.mirrored ? clip_triangle(c.vec(0), c.vec(2), c.vec(1))
                            : clip_triangle(c.vec(0), c.vec(1), c.vec(2))),
        frame(triangle_frame(c.at, layer.mirrored)),
        patch(patch_polynomial(layer, triangle, frame)) {}

  Color4 color_at(double x, double y) const {
    const double q = clamp_unit((y - frame.top_y) * frame.inverse_height);
    const double u = clamp_unit((x - frame.long_edge_x(y)) * frame.inverse_width);
    return patch_color(patch, static_cast<float>(u), static_cast<float>(q));
  }
};

/// Bits from `begin` up to but not `end`, both in [0, 64].
std::uint64_t bit_range(int begin, int end) {
  if (begin >= end) return 0;
  return (~std::uint64_t{0} << begin) & (~std::uint64_t{0} >> (64 - end));
}

}  // namespace

void MixedPixels::mark_edge(Vec2 a, Vec2 b, const Tile& tile) {
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
    for (int word = begin / 64; word <= (end - 1) / 64; ++word) {
      mask_[y - tile.y0][word] |=
          bit_range(std::max(begin - 64 * word, 0), std::min(end - 64 * word, 64));
    }
  }
}

void MixedPixels::mark(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  std::memset(mask_, 0, sizeof(mask_));
  for (std::size_t i = 0; i < triangles.count; ++i) {
    const std::uint32_t t = triangles.triangle[i];
    const std::uint8_t* is_curve = layer.edge_is_curve + std::size_t{3} * t;
    if (!(is_curve[0] | is_curve[1] | is_curve[2])) continue;
    const Corners corners = corners_of(layer, t);
    for (int k = 0; k < 3; ++k)
      if (is_curve[k]) mark_edge(corners.vec(k), corners.vec((k + 1) % 3), tile);
  }
}

void MixedPixels::number_pixels() {
  std::uint32_t count = 0;
  for (int row = 0; row < kTileHeight; ++row) {
    for (int word = 0; word < kWordsPerRow; ++word) {
      first_sum_[row][word] = count;
      count += static_cast<std::uint32_t>(std::popcount(mask_[row][word]));
    }
  }
  sum_.assign(count, Sum{});
}

/// visit(x, index of its sum) for the marked pixels of a row from begin up to but not end.
template <class Visit>
void MixedPixels::for_each_pixel(int row, int begin, int end, const Visit& visit) const {
  for (int word = begin / 64; word <= (end - 1) / 64; ++word) {
    const std::uint64_t marked = mask_[row][word];
    const int first_bit = std::max(begin - 64 * word, 0);
    std::uint64_t left = marked & bit_range(first_bit, std::min(end - 64 * word, 64));
    if (left == 0) continue;
    std::uint32_t index =
        first_sum_[row][word] +
        static_cast<std::uint32_t>(std::popcount(marked & bit_range(0, first_bit)));
    for (; left != 0; left &= left - 1) visit(64 * word + std::countr_zero(left), index++);
  }
}

bool MixedPixels::any_marked(const PixelRange& range) const {
  for (int row = range.first_row; row < range.end_row; ++row) {
    for (int word = range.begin / 64; word <= (range.end - 1) / 64; ++word) {
      const int begin = std::max(range.begin - 64 * word, 0);
      if (mask_[row][word] & bit_range(begin, std::min(range.end - 64 * word, 64))) return true;
    }
  }
  return false;
}

void MixedPixels::add_triangle(const LayerView& layer, std::uint32_t triangle, const Tile& tile) {
  const Corners corners = corners_of(layer, triangle);
  Box box;
  for (int k = 0; k < 3; ++k) box.extend(corners.vec(k));
  const int last_x = tile.width - 1, last_y = tile.height - 1;
  const PixelRange range{clamped_floor(box.min.x - tile.x0, 0, last_x),
                         clamped_floor(box.max.x - tile.x0, 0, last_x) + 1,
                         clamped_floor(box.min.y - tile.y0, 0, last_y),
                         clamped_floor(box.max.y - tile.y0, 0, last_y) + 1};
  if (!any_marked(range)) return;
  const MixedTriangle mixed(layer, triangle, corners);
  for (int row = range.first_row; row < range.end_row; ++row) {
    for_each_pixel(row, range.begin, range.end, [&](int column, std::uint32_t index) {
      const int x = tile.x0 + column;
      const int y = tile.y0 + row;
      const Coverage part = pixel_coverage(mixed.clip, x, y);
      if (!(part.area > 0)) return;
      const Color4 color = mixed.color_at(x + part.centroid.x, y + part.centroid.y);
      Sum& sum = sum_[index];
      const float area = static_cast<float>(part.area);
      if (sum.area == 0) color.store(sum.first);
      const Color4 difference = color - Color4::load(sum.first);
      (Color4::load(sum.rest) + Color4(area) * difference).store(sum.rest);
      sum.area += area;
    });
  }
}

void MixedPixels::write(const Tile& tile) const {
  // A centre of which half the square is covered is one that the centre rule decides.
  constexpr float kLeastArea = 0.5f + 1e-6f;
  for (int row = 0; row < tile.height; ++row) {
    for_each_pixel(row, 0, tile.width, [&](int x, std::uint32_t index) {
      const Sum& sum = sum_[index];
      if (sum.area < kLeastArea) return;
      const std::size_t offset = static_cast<std::size_t>(row) * kTileStride + x;
      for (int c = 0; c < 3; ++c) tile.color[c][offset] = sum.first[c] + sum.rest[c] / sum.area;
      if (tile.alpha) tile.alpha[offset] = 1;
    });
  }
}

void MixedPixels::paint(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  mark(layer, triangles, tile);
  number_pixels();
  if (sum_.empty()) return;
  for (std::size_t i = 0; i < triangles.count; ++i)
    add_triangle(layer, triangles.triangle[i], tile);
  write(tile);
}

}  // namespace sfumato::raster
