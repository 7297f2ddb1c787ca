#pragma once

#include "base/lanes.hpp"
#include "raster/kernels/blue_noise.hpp"
#include "raster/kernels/span_kernels.hpp"

/// Code values to bytes. Compiled for every instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// A row of the dither's thresholds, (rank + 1/2) / 256; the first ones repeated after the last, so
/// that a register may be read from any column.
struct DitherRow {
  float threshold[kBlueNoiseSide + 16];

  explicit DitherRow(int y) {
    for (int x = 0; x < kBlueNoiseSide + 16; ++x) {
      const int rank = kBlueNoise[y & (kBlueNoiseSide - 1)][x & (kBlueNoiseSide - 1)];
      threshold[x] = (static_cast<float>(rank) + 0.5f) * (1.0f / 256);
    }
  }
};

/// Neighbours that differ by at most this, 1/2000 of a code value, count as one colour. Such
/// differences come from rounding in an even area, or from a slope of one step in 2000 pixels.
inline constexpr float kEvenStep = 2e-6f;

/// A row of a plane and its neighbours. A neighbour beyond the tile's edge is replaced by the one
/// on the opposite side of the pixel.
struct DitheredRow {
  const float* above;
  const float* below;
  float value[kTileStride + 32];  ///< the value of column x is at x + 1

  DitheredRow(const float* plane, int row, int width, int height) {
    const float* here = plane + static_cast<std::ptrdiff_t>(row) * kTileStride;
    const bool is_alone = height == 1;
    above = row > 0 ? here - kTileStride : is_alone ? here : here + kTileStride;
    below = row + 1 < height ? here + kTileStride : is_alone ? here : here - kTileStride;
    __builtin_memcpy(value + 1, here, static_cast<std::size_t>(width) * sizeof(float));
    value[0] = here[width > 1 ? 1 : 0];
    value[width + 1] = here[width > 1 ? width - 2 : 0];
  }

  /// Returns where to round: even areas are rounded, because noise would be visible there. Beside
  /// an edge the side away from it decides.
  template <int W>
  SFUMATO_INLINE LaneMask<W> is_even(int x) const {
    using F = Lanes<W>;
    const F v = F::load(value + 1 + x);
    const F across = min(abs(v - F::load(value + x)), abs(v - F::load(value + x + 2)));
    const F along = min(abs(v - F::load(above + x)), abs(v - F::load(below + x)));
    return max(across, along) <= F(kEvenStep);
  }
};

/// Returns round(maximum clamp(v)), or with the thresholds t of the dither, floor(maximum clamp(v)
/// + t). As 0 < t < 1, a value that is a whole number of steps is unchanged.
template <int W>
SFUMATO_INLINE Lanes<W> quantized(const float* value, float maximum, const Lanes<W>& threshold) {
  using F = Lanes<W>;
  return to_float(to_int(min(max(F::load(value), F(0)), F(1)) * F(maximum) + threshold));
}

/// Computes the 8-bit code values of a row of a plane.
template <int W>
SFUMATO_INLINE void round_row(const float* plane, int row, const Tile& tile, float* code) {
  const float* value = plane + static_cast<std::ptrdiff_t>(row) * kTileStride;
  for (int x = 0; x < tile.width; x += W) {
    quantized<W>(value + x, 255, Lanes<W>(0.5f)).store(code + x);
  }
}

/// Does the same, dithered by the thresholds from `first` on.
template <int W>
SFUMATO_INLINE void dither_row(const float* plane, int row, const Tile& tile,
                               const DitherRow& thresholds, int first, float* code) {
  using F = Lanes<W>;
  const DitheredRow values(plane, row, tile.width, tile.height);
  for (int x = 0; x < tile.width; x += W) {
    const F noise = F::load(thresholds.threshold + ((first + x) & (kBlueNoiseSide - 1)));
    const F threshold = select(values.is_even<W>(x), F(0.5f), noise);
    quantized<W>(values.value + 1 + x, 255, threshold).store(code + x);
  }
}

/// The code values of a row's pixels.
struct CodeRow {
  float channel[4][kTileStride];

  template <int W>
  SFUMATO_INLINE void fill(const Tile& tile, int row, bool dither) {
    const auto plane = [&](int c) { return c < 3 ? tile.color[c] : tile.alpha; };
    const int channels = tile.alpha ? 4 : 3;
    if (!dither) {
      for (int c = 0; c < channels; ++c) round_row<W>(plane(c), row, tile, channel[c]);
      return;
    }
    // The same noise for all colours keeps greys grey. Alpha uses another part of the table.
    const int y = tile.y0 + row;
    const DitherRow thresholds(y);
    for (int c = 0; c < 3; ++c) dither_row<W>(plane(c), row, tile, thresholds, tile.x0, channel[c]);
    if (!tile.alpha) return;
    constexpr int kHalf = kBlueNoiseSide / 2;
    dither_row<W>(tile.alpha, row, tile, DitherRow(y + kHalf), tile.x0 + kHalf, channel[3]);
  }
};

/// Packs a row of 8-bit pixels, r + 2^8 g + 2^16 b: exact in single precision.
template <int W>
SFUMATO_INLINE void pack_words(const CodeRow& row, int width, std::int32_t* word) {
  using F = Lanes<W>;
  for (int x = 0; x < width; x += W) {
    const F r = F::load(row.channel[0] + x), g = F::load(row.channel[1] + x);
    to_int(r + F(256) * g + F(65536) * F::load(row.channel[2] + x)).store(word + x);
  }
}

/// Writes three bytes per pixel, four at a time except for the last pixel, since another thread may
/// be writing the tile to the right.
SFUMATO_INLINE void write_rgb8(const std::int32_t* word, int width, std::uint8_t* out) {
  for (int x = 0; x + 1 < width; ++x) __builtin_memcpy(out + 3 * x, word + x, 4);
  __builtin_memcpy(out + 3 * (width - 1), word + (width - 1), 3);
}

SFUMATO_INLINE void write_rgba8(const std::int32_t* word, const float* alpha, int width,
                                std::uint8_t* out) {
  for (int x = 0; x < width; ++x) {
    __builtin_memcpy(out + 4 * x, word + x, 3);
    out[4 * x + 3] = static_cast<std::uint8_t>(alpha[x]);
  }
}

/// Columns of a tile from its left, at least one.
struct WrittenColumns {
  int begin, count;
};

/// Rounds the whole row, because noise depends on neighbouring pixels.
template <int W>
SFUMATO_INLINE void write_row8(const Tile& tile, int row, const WrittenColumns& columns,
                               bool dither, std::uint8_t* out) {
  CodeRow codes;
  codes.fill<W>(tile, row, dither);
  std::int32_t word[kTileStride];
  pack_words<W>(codes, tile.width, word);
  if (tile.alpha)
    write_rgba8(word + columns.begin, codes.channel[3] + columns.begin, columns.count, out);
  else
    write_rgb8(word + columns.begin, columns.count, out);
}

template <int W>
SFUMATO_INLINE void write_row16(const Tile& tile, int row, const WrittenColumns& columns,
                                std::uint8_t* out) {
  const std::size_t offset =
      static_cast<std::size_t>(row) * kTileStride + static_cast<std::size_t>(columns.begin);
  const int channels = tile.alpha ? 4 : 3;
  float value[W];
  for (int c = 0; c < channels; ++c) {
    const float* plane = (c < 3 ? tile.color[c] : tile.alpha) + offset;
    for (int x = 0; x < columns.count; x += W) {
      quantized<W>(plane + x, 65535, Lanes<W>(0.5f)).store(value);
      for (int i = 0; i < W && x + i < columns.count; ++i) {
        const std::uint16_t sample = static_cast<std::uint16_t>(value[i]);
        __builtin_memcpy(out + 2 * (static_cast<std::size_t>(x + i) * channels + c), &sample, 2);
      }
    }
  }
}

template <int W>
void write_pixels(const Tile& tile, const ImageTarget& target) {
  const bool wide = target.format == PixelFormat::rgb16 || target.format == PixelFormat::rgba16;
  const std::size_t pixel_bytes = static_cast<std::size_t>((tile.alpha ? 4 : 3) * (wide ? 2 : 1));
  // Calls no function of another header: the linker would merge its copies for each instruction
  // set.
  const PixelRect& window = target.window;
  const int x0 = tile.x0 > window.x0 ? tile.x0 : window.x0;
  const int y0 = tile.y0 > window.y0 ? tile.y0 : window.y0;
  const int tile_x1 = tile.x0 + tile.width, tile_y1 = tile.y0 + tile.height;
  const int x1 = tile_x1 < window.x1 ? tile_x1 : window.x1;
  const int y1 = tile_y1 < window.y1 ? tile_y1 : window.y1;
  if (x0 >= x1) return;
  const WrittenColumns columns{x0 - tile.x0, x1 - x0};
  for (int y = y0; y < y1; ++y) {
    std::uint8_t* out = target.bytes + static_cast<std::size_t>(y - window.y0) * target.row_bytes +
                        static_cast<std::size_t>(x0 - window.x0) * pixel_bytes;
    if (wide)
      write_row16<W>(tile, y - tile.y0, columns, out);
    else
      write_row8<W>(tile, y - tile.y0, columns, target.dither, out);
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
