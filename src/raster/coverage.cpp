#include "raster/coverage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "raster/clip.hpp"

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

ClipTriangle clip_of(const LayerView& layer, const Corners& c) {
  return layer.mirrored ? clip_triangle(c.vec(0), c.vec(2), c.vec(1))
                        : clip_triangle(c.vec(0), c.vec(1), c.vec(2));
}

/// Shades what is painted straight into a tile: opaque, in code values.
class OpaqueShader {
 public:
  explicit OpaqueShader(const LayerView& layer) : layer_(layer) {}

  const LayerView& layer() const { return layer_; }
  void begin_triangle(std::uint32_t triangle, const TriangleFrame& frame) {
    patch_ = patch_polynomial(ColorChannels(layer_), layer_.order, triangle, frame);
  }
  Color4 at(const PatchPoint& p, Vec2) const { return patch_color(patch_, p) + color4(0, 0, 0, 1); }

 private:
  const LayerView& layer_;
  PatchPolynomial patch_;
};

/// Tells the pixels that lie in a layer's frame with all their square.
class FrameInImage {
 public:
  explicit FrameInImage(const LayerView& layer)
      : frame_(layer.frame), layer_from_image_(inverse(layer.image_from_layer)) {}

  bool holds(int x, int y) const {
    const Affine& m = layer_from_image_;
    const Vec2 center = m({x + 0.5, y + 0.5});
    const Vec2 reach{0.5 * (std::fabs(m.a) + std::fabs(m.c)),
                     0.5 * (std::fabs(m.b) + std::fabs(m.d))};
    return center.x - reach.x >= frame_.min.x && center.x + reach.x <= frame_.max.x &&
           center.y - reach.y >= frame_.min.y && center.y + reach.y <= frame_.max.y;
  }

 private:
  Box frame_;
  Affine layer_from_image_;
};

/// Bits from `begin` up to but not `end`, both in [0, 64].
std::uint64_t bit_range(int begin, int end) {
  if (begin >= end) return 0;
  return (~std::uint64_t{0} << begin) & (~std::uint64_t{0} >> (64 - end));
}

/// Of a pixel in the tile's planes.
std::size_t offset(int x, int row) {
  return static_cast<std::size_t>(row) * kTileStride + static_cast<std::size_t>(x);
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

template <class Shader>
void MixedPixels::add_triangle(Shader* shader, std::uint32_t triangle, const Tile& tile) {
  const Corners corners = corners_of(shader->layer(), triangle);
  Box box;
  for (int k = 0; k < 3; ++k) box.extend(corners.vec(k));
  const int last_x = tile.width - 1, last_y = tile.height - 1;
  const PixelRange range{clamped_floor(box.min.x - tile.x0, 0, last_x),
                         clamped_floor(box.max.x - tile.x0, 0, last_x) + 1,
                         clamped_floor(box.min.y - tile.y0, 0, last_y),
                         clamped_floor(box.max.y - tile.y0, 0, last_y) + 1};
  if (!any_marked(range)) return;
  const ClipTriangle clip = clip_of(shader->layer(), corners);
  const TriangleFrame frame = triangle_frame(corners.at, shader->layer().mirrored);
  shader->begin_triangle(triangle, frame);
  for (int row = range.first_row; row < range.end_row; ++row) {
    for_each_pixel(row, range.begin, range.end, [&](int column, std::uint32_t index) {
      const int x = tile.x0 + column;
      const int y = tile.y0 + row;
      const Coverage part = pixel_coverage(clip, x, y);
      if (!(part.area > 0)) return;
      const Vec2 p{x + part.centroid.x, y + part.centroid.y};
      // Shaders are filtered over the pixel's square already: they are asked at its centre.
      const Color4 color = shader->at(patch_point(frame, p.x, p.y), {x + 0.5, y + 0.5});
      Sum& sum = sum_[index];
      const float area = static_cast<float>(part.area);
      if (sum.area == 0) color.store(sum.first);
      const Color4 difference = color - Color4::load(sum.first);
      (Color4::load(sum.rest) + Color4(area) * difference).store(sum.rest);
      sum.area += area;
      sum.moment[0] += area * static_cast<float>(part.centroid.x);
      sum.moment[1] += area * static_cast<float>(part.centroid.y);
    });
  }
}

/// visit(x, row, index of its sum) for every marked pixel.
template <class Visit>
void MixedPixels::for_each_marked(const Tile& tile, const Visit& visit) const {
  for (int row = 0; row < tile.height; ++row) {
    for_each_pixel(row, 0, tile.width, [&](int x, std::uint32_t index) { visit(x, row, index); });
  }
}

/// is_straight: onto what lies below, not by itself.
void MixedPixels::write(const LayerView& layer, const Tile& tile, bool is_straight) {
  // A centre of which half the square is covered is one that the centre rule decides.
  constexpr float kLeastArea = 0.5f + 1e-6f;
  // More is all of a pixel, but for the rounding of the sum.
  constexpr float kWholeArea = 1 - 1e-5f;
  const FrameInImage frame(layer);
  const bool is_opaque = layer.opacity.channel_count == 0;
  for_each_marked(tile, [&](int x, int row, std::uint32_t index) {
    const Sum& sum = sum_[index];
    float share = sum.area > kWholeArea ? 1 : sum.area;
    if (share < 1 && is_opaque && !frame.holds(tile.x0 + x, tile.y0 + row)) {
      if (share < kLeastArea) return;
      share = 1;
    }
    const std::size_t at = offset(x, row);
    float* const target[4] = {tile.color[0] + at, tile.color[1] + at, tile.color[2] + at,
                              tile.alpha ? tile.alpha + at : nullptr};
    PixelPart part{share, {sum.moment[0], sum.moment[1]}, {}};
    for (int c = 0; c < 4; ++c)
      part.color[c] = sum.area > 0 ? sum.first[c] + sum.rest[c] / sum.area : 0;
    float out[4];
    std::copy_n(part.color, 4, out);
    if (share < 1) {
      // What overshoots is clamped later where it stands alone.
      for (float& channel : part.color) channel = std::clamp(channel, 0.0f, 1.0f);
      for (int c = 0; c < 4; ++c) out[c] = share * part.color[c];
      if (is_straight) abutting_.paint(tile.x0 + x, tile.y0 + row, part, sum.below, out);
    }
    for (int c = 0; c < 4 && target[c]; ++c) *target[c] = out[c];
  });
}

template <class Shader>
void MixedPixels::add_triangles(Shader* shader, const TriangleList& triangles, const Tile& tile) {
  if (sum_.empty()) return;
  for (std::size_t i = 0; i < triangles.count; ++i)
    add_triangle(shader, triangles.triangle[i], tile);
}

void MixedPixels::begin(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  mark(layer, triangles, tile);
  number_pixels();
  for_each_marked(tile, [&](int x, int row, std::uint32_t index) {
    const std::size_t at = offset(x, row);
    for (int c = 0; c < 3; ++c) sum_[index].below[c] = tile.color[c][at];
    sum_[index].below[3] = tile.alpha ? tile.alpha[at] : 1;
  });
}

void MixedPixels::paint(const LayerView& layer, const TriangleList& triangles, const Tile& tile) {
  OpaqueShader shader(layer);
  add_triangles(&shader, triangles, tile);
  write(layer, tile, true);
}

void MixedPixels::paint(PointShader* shader, const TriangleList& triangles, const Tile& tile) {
  mark(shader->layer(), triangles, tile);
  number_pixels();
  add_triangles(shader, triangles, tile);
  write(shader->layer(), tile, false);
}

}  // namespace sfumato::raster
