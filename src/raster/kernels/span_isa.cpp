#include "raster/kernels/blend_kernel.hpp"
#include "raster/kernels/patch_polynomial.hpp"
#include "raster/kernels/pixel_mask.hpp"
#include "raster/kernels/placed_triangles.hpp"
#include "raster/kernels/quantize_kernel.hpp"
#include "raster/kernels/span_kernels.hpp"

/// Interior pixels: the patch's value at pixel centres. Compiled for every instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// Returns ceil(x), at least low and at most high; 0 <= low <= high. low where x is NaN.
SFUMATO_INLINE int clamped_ceil(double x, int low, int high) {
  const double lifted = x > low ? x : low;
  const double cut = lifted < high ? lifted : high;
  const int down = static_cast<int>(cut);
  return down + (cut > down);
}

template <int W>
struct LaneIndexTable {
  float value[W];
};

template <int W>
constexpr LaneIndexTable<W> make_lane_indices() {
  LaneIndexTable<W> table{};
  for (int i = 0; i < W; ++i) table.value[i] = static_cast<float>(i);
  return table;
}

template <int W>
inline constexpr LaneIndexTable<W> kLaneIndices = make_lane_indices<W>();

/// Pixels of one row: count of them from `offset` in the tile's planes; u of pixel i is
/// u0 + i u_step.
struct Span {
  std::size_t offset;
  int count;
  float u0, u_step;
};

/// The polynomials of the channels along a row: value[c][power of u].
template <int kChannels>
struct ChannelPolynomials {
  float value[kChannels][4];
};

template <int kChannels>
SFUMATO_INLINE ChannelPolynomials<kChannels> by_channel(const RowPolynomial& row) {
  float k[4][4];
  for (int i = 0; i < 4; ++i) row.k[i].store(k[i]);
  ChannelPolynomials<kChannels> result;
  for (int c = 0; c < kChannels; ++c)
    for (int i = 0; i < 4; ++i) result.value[c][i] = k[i][c];
  return result;
}

template <int W>
SFUMATO_INLINE Lanes<W> cubic(const float (&k)[4], const Lanes<W>& u) {
  using F = Lanes<W>;
  return F(k[0]) + u * (F(k[1]) + u * (F(k[2]) + u * F(k[3])));
}

/// Writes three channels: the colour of an opaque layer; or four: colour and alpha.
template <int W, int kChannels>
SFUMATO_INLINE void draw_span(const RowPolynomial& row, const Span& span, const Tile& tile) {
  using F = Lanes<W>;
  const ChannelPolynomials<kChannels> k = by_channel<kChannels>(row);
  const F lane_index = F::load(kLaneIndices<W>.value);
  const auto u_at = [&](int first) {
    const F index = lane_index + F(static_cast<float>(first));
    return min(max(F(span.u0) + index * F(span.u_step), F(0)), F(1));
  };
  float* pixel[kChannels];
  for (int c = 0; c < kChannels; ++c) pixel[c] = (c < 3 ? tile.color[c] : tile.alpha) + span.offset;
  int i = 0;
  for (; i + W <= span.count; i += W) {
    const F u = u_at(i);
    for (int c = 0; c < kChannels; ++c) cubic<W>(k.value[c], u).store(pixel[c] + i);
  }
  if (i < span.count) {
    const F u = u_at(i);
    const auto painted = lane_index < F(static_cast<float>(span.count - i));
    for (int c = 0; c < kChannels; ++c) {
      float* const last = pixel[c] + i;
      select(painted, cubic<W>(k.value[c], u), F::load(last)).store(last);
    }
  }
  if (kChannels > 3 || !tile.alpha) return;
  for (i = 0; i < span.count; ++i) tile.alpha[span.offset + i] = 1;
}

/// Returns whether triangle i covers only `skipped` pixels. Its bounding box decides, if an edge's
/// crossing with a row is less than half a pixel wrong.
SFUMATO_INLINE bool is_skipped(const PlacedTriangles& placed, std::size_t i,
                               const PixelMask& skipped) {
  constexpr double kExactBelowPx = 1e9;
  return placed.left[i] > -kExactBelowPx && placed.right[i] < kExactBelowPx &&
         holds_all(skipped,
                   {placed.begin[i], placed.end[i], placed.first_row[i], placed.end_row[i]});
}

/// Calls body(triangle, its corners, top, bottom) for the triangles of a list.
template <class Body>
SFUMATO_INLINE void for_each_triangle(const LayerView& layer, const TriangleList& triangles,
                                      const Tile& tile, const PixelMask* skipped,
                                      const Body& body) {
  PlacedTriangles placed;
  for (std::size_t first = 0; first < triangles.count; first += PlacedTriangles::kMost) {
    const std::uint32_t* triangle = triangles.triangle + first;
    const std::size_t rest = triangles.count - first;
    const std::size_t count = rest < PlacedTriangles::kMost ? rest : PlacedTriangles::kMost;
    place_triangles(layer, triangle, count, tile, &placed);
    for (std::size_t i = 0; i < count; ++i) {
      if (skipped && is_skipped(placed, i, *skipped)) continue;
      const PixelPoint corner[3] = {{placed.x[0][i], placed.y[0][i]},
                                    {placed.x[1][i], placed.y[1][i]},
                                    {placed.x[2][i], placed.y[2][i]}};
      body(triangle[i], corner, placed.top[i], placed.bottom[i]);
    }
  }
}

/// The pixels of a row of the image whose centres lie in a triangle.
struct TriangleRow {
  int y, begin, end;
  double long_x;  ///< TriangleFrame::long_edge_x()
};

/// Calls body(frame, row) for each row of the tile that has pixel centres in the triangle.
template <class Body>
SFUMATO_INLINE void for_each_row(const LayerView& layer, const PixelPoint (&corner)[3], double top,
                                 double bottom, const Tile& tile, const Body& body) {
  const int y_end = tile.y0 + tile.height;
  const int first_row = clamped_ceil(top - 0.5, tile.y0, y_end);
  const int end_row = clamped_ceil(bottom - 0.5, tile.y0, y_end);
  if (first_row >= end_row) return;
  const TriangleFrame frame = triangle_frame(corner, layer.mirrored);
  for (int y = first_row; y < end_row; ++y) {
    const double center_y = y + 0.5;
    const double long_x = frame.long_edge_x(center_y);
    const double short_x = frame.short_edges_x(center_y);
    const double left = frame.middle_on_right ? long_x : short_x;
    const double right = frame.middle_on_right ? short_x : long_x;
    const int x_end = tile.x0 + tile.width;
    const int begin = clamped_ceil(left - 0.5, tile.x0, x_end);
    const int end = clamped_ceil(right - 0.5, tile.x0, x_end);
    if (begin < end) body(frame, TriangleRow{y, begin, end, long_x});
  }
}

template <int W, class Channels>
SFUMATO_INLINE void draw_channels(const LayerView& layer, const Channels& channels,
                                  const TriangleList& triangles, const Tile& tile,
                                  const PixelMask* skipped) {
  for_each_triangle(
      layer, triangles, tile, skipped,
      [&](std::uint32_t triangle, const PixelPoint(&corner)[3], double top,
          double bottom) SFUMATO_INLINE_LAMBDA {
        PatchPolynomial patch;
        bool patch_is_known = false;
        const auto draw_row = [&](const TriangleFrame& frame,
                                  const TriangleRow& pixels) SFUMATO_INLINE_LAMBDA {
          const int row = pixels.y - tile.y0, column = pixels.begin - tile.x0;
          if (skipped && holds_all(*skipped, {column, pixels.end - tile.x0, row, row + 1})) return;
          if (!patch_is_known) patch = patch_polynomial(channels, layer.order, triangle, frame);
          patch_is_known = true;
          const double q = (pixels.y + 0.5 - frame.top_y) * frame.inverse_height;
          const double u0 = clamp_unit((pixels.begin + 0.5 - pixels.long_x) * frame.inverse_width);
          const std::size_t offset = static_cast<std::size_t>(row) * kTileStride + column;
          draw_span<W, Channels::kCount>(row_polynomial(patch, static_cast<float>(q)),
                                         {offset, pixels.end - pixels.begin, static_cast<float>(u0),
                                          static_cast<float>(frame.inverse_width)},
                                         tile);
        };
        for_each_row(layer, corner, top, bottom, tile, draw_row);
      });
}

inline void cover_triangles(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                            PixelMask* covered) {
  for_each_triangle(layer, triangles, tile, nullptr,
                    [&](std::uint32_t, const PixelPoint(&corner)[3], double top, double bottom) {
                      const auto cover_row = [&](const TriangleFrame&, const TriangleRow& pixels) {
                        const int begin = pixels.begin - tile.x0, end = pixels.end - tile.x0;
                        for (int i = begin / 64; i <= (end - 1) / 64; ++i)
                          covered->word[pixels.y - tile.y0][i] |= columns_in_word(i, begin, end);
                      };
                      for_each_row(layer, corner, top, bottom, tile, cover_row);
                    });
}

template <int W>
void draw_triangles(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                    const PixelMask* skipped) {
  draw_channels<W>(layer, ColorChannels(layer), triangles, tile, skipped);
}

template <int W>
void draw_color_opacity(const LayerView& layer, const TriangleList& triangles, const Tile& tile,
                        const PixelMask* skipped) {
  draw_channels<W>(layer, ColorOpacityChannels(layer), triangles, tile, skipped);
}

template <int W>
void draw_weights(const LayerView& layer, const FieldView& field, int first_channel,
                  const TriangleList& triangles, const Tile& tile) {
  draw_channels<W>(layer, WeightChannels(field, first_channel), triangles, tile, nullptr);
}

}  // namespace sfumato::raster::inline SFUMATO_ISA

namespace sfumato::raster {

const SpanKernels& span_kernels(LaneCount<SFUMATO_ISA_LANES>) {
  constexpr int kLanes = SFUMATO_ISA_LANES;
  static constexpr SpanKernels kKernels{place_triangles,        box_of_triangles,
                                        draw_triangles<kLanes>, draw_color_opacity<kLanes>,
                                        draw_weights<kLanes>,   cover_triangles,
                                        finish_shading<kLanes>, blend<kLanes>,
                                        unpremultiply<kLanes>,  write_pixels<kLanes>};
  return kKernels;
}

}  // namespace sfumato::raster
