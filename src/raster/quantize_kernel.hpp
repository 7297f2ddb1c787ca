#pragma once

#include "base/lanes.hpp"
#include "raster/span_kernels.hpp"

/// Code values to bytes. Compiled for every instruction set.
namespace sfumato::raster::inline SFUMATO_ISA {

/// Thresholds of the ordered 8×8 dither (Bayer's matrix), (rank + 1/2) / 64; each row twice over,
/// so that a register may be read from any column.
struct DitherTable {
  float threshold[8][24];
};

constexpr DitherTable make_dither_table() {
  DitherTable table{};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 24; ++x) {
      int rank = 0;
      for (int bit = 0; bit < 3; ++bit) {
        const int a = (x >> bit) & 1;
        const int b = (y >> bit) & 1;
        rank |= (2 * (a ^ b) + b) << (2 * (2 - bit));
      }
      table.threshold[y][x] = (static_cast<float>(rank) + 0.5f) / 64;
    }
  }
  return table;
}

inline constexpr DitherTable kDither = make_dither_table();

/// round(maximum clamp(v)), or with the thresholds of the dither floor(maximum clamp(v) + t): as t
/// lies inside (0, 1), a value that is a whole number of steps stays itself.
template <int W>
SFUMATO_INLINE Lanes<W> quantized(const float* value, float maximum, const Lanes<W>& threshold) {
  using F = Lanes<W>;
  return to_float(to_int(min(max(F::load(value), F(0)), F(1)) * F(maximum) + threshold));
}

template <int W>
SFUMATO_INLINE Lanes<W> threshold_at(const float* thresholds, int x) {
  return thresholds ? Lanes<W>::load(thresholds + (x & 7)) : Lanes<W>(0.5f);
}

/// A row of 8-bit pixels, r + 2^8 g + 2^16 b: exact in single precision.
template <int W>
SFUMATO_INLINE void pack_words(const Tile& tile, std::size_t offset, const float* thresholds,
                               std::int32_t* word) {
  using F = Lanes<W>;
  for (int x = 0; x < tile.width; x += W) {
    const F threshold = threshold_at<W>(thresholds, x);
    const F r = quantized<W>(tile.color[0] + offset + x, 255, threshold);
    const F g = quantized<W>(tile.color[1] + offset + x, 255, threshold);
    const F b = quantized<W>(tile.color[2] + offset + x, 255, threshold);
    to_int(r + F(256) * g + F(65536) * b).store(word + x);
  }
}

/// Three bytes to a pixel, written four at a time but for the last: the tile to the right may be
/// written by another thread.
SFUMATO_INLINE void write_rgb8(const std::int32_t* word, int width, std::uint8_t* out) {
  for (int x = 0; x + 1 < width; ++x) __builtin_memcpy(out + 3 * x, word + x, 4);
  __builtin_memcpy(out + 3 * (width - 1), word + (width - 1), 3);
}

SFUMATO_INLINE void write_rgba8(const std::int32_t* word, const float* alpha, int width,
                                std::uint8_t* out) {
  for (int x = 0; x < width; ++x) {
    __builtin_memcpy(out + 4 * x, word + x, 3);
    out[4 * x + 3] = static_cast<std::uint8_t>(alpha[x] * 255 + 0.5f);
  }
}

template <int W>
SFUMATO_INLINE void write_row8(const Tile& tile, int row, bool dither, std::uint8_t* out) {
  const std::size_t offset = static_cast<std::size_t>(row) * kTileStride;
  std::int32_t word[kTileStride];
  pack_words<W>(tile, offset, dither ? kDither.threshold[(tile.y0 + row) & 7] : nullptr, word);
  if (tile.alpha)
    write_rgba8(word, tile.alpha + offset, tile.width, out);
  else
    write_rgb8(word, tile.width, out);
}

template <int W>
SFUMATO_INLINE void write_row16(const Tile& tile, int row, std::uint8_t* out) {
  const std::size_t offset = static_cast<std::size_t>(row) * kTileStride;
  const int channels = tile.alpha ? 4 : 3;
  float value[W];
  for (int c = 0; c < channels; ++c) {
    const float* plane = (c < 3 ? tile.color[c] : tile.alpha) + offset;
    for (int x = 0; x < tile.width; x += W) {
      quantized<W>(plane + x, 65535, Lanes<W>(0.5f)).store(value);
      for (int i = 0; i < W && x + i < tile.width; ++i) {
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
  for (int y = 0; y < tile.height; ++y) {
    std::uint8_t* out = target.bytes + static_cast<std::size_t>(tile.y0 + y) * target.row_bytes +
                        static_cast<std::size_t>(tile.x0) * pixel_bytes;
    if (wide)
      write_row16<W>(tile, y, out);
    else
      write_row8<W>(tile, y, target.dither, out);
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
