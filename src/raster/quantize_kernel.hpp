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

/// Integers of one row of a tile, for one channel.
struct QuantizedRow {
  std::int32_t value[3][kTileStride];
};

/// floor(maximum clamp(v) + threshold): with thresholds inside (0, 1) a value that is a whole
/// number of steps stays itself.
template <int W>
SFUMATO_INLINE void quantize_row(const Tile& tile, int row, float maximum, bool dither,
                                 QuantizedRow* out) {
  using F = Lanes<W>;
  const std::size_t offset = static_cast<std::size_t>(row) * kTileStride;
  const float* thresholds = kDither.threshold[(tile.y0 + row) & 7];
  for (int c = 0; c < 3; ++c) {
    for (int x = 0; x < tile.width; x += W) {
      const F value = F::load(tile.color[c] + offset + x);
      const F threshold = dither ? F::load(thresholds + (x & 7)) : F(0.5f);
      to_int(min(max(value, F(0)), F(1)) * F(maximum) + threshold).store(out->value[c] + x);
    }
  }
}

/// Three bytes to a pixel, written four at a time but for the last: the tile to the right may be
/// written by another thread.
SFUMATO_INLINE void pack_rgb8(const QuantizedRow& row, int width, std::uint8_t* out) {
  for (int x = 0; x < width; ++x, out += 3) {
    const std::uint8_t pixel[4] = {static_cast<std::uint8_t>(row.value[0][x]),
                                   static_cast<std::uint8_t>(row.value[1][x]),
                                   static_cast<std::uint8_t>(row.value[2][x]), 0};
    __builtin_memcpy(out, pixel, x + 1 < width ? 4 : 3);
  }
}

template <class Channel>
SFUMATO_INLINE void pack(const QuantizedRow& row, const float* alpha, int width, float maximum,
                         std::uint8_t* out) {
  const int channels = alpha ? 4 : 3;
  for (int x = 0; x < width; ++x, out += channels * sizeof(Channel)) {
    Channel pixel[4];
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<Channel>(row.value[c][x]);
    if (alpha) pixel[3] = static_cast<Channel>(alpha[x] * maximum + 0.5f);
    __builtin_memcpy(out, pixel, channels * sizeof(Channel));
  }
}

template <int W>
void write_pixels(const Tile& tile, const ImageTarget& target) {
  const bool wide = bytes_per_channel(target.format) == 2;
  const float maximum = wide ? 65535.0f : 255.0f;
  const std::size_t pixel_bytes = static_cast<std::size_t>((tile.alpha ? 4 : 3) * (wide ? 2 : 1));
  QuantizedRow row;
  for (int y = 0; y < tile.height; ++y) {
    quantize_row<W>(tile, y, maximum, target.dither && !wide, &row);
    std::uint8_t* out = target.bytes + static_cast<std::size_t>(tile.y0 + y) * target.row_bytes +
                        static_cast<std::size_t>(tile.x0) * pixel_bytes;
    const float* alpha =
        tile.alpha ? tile.alpha + static_cast<std::size_t>(y) * kTileStride : nullptr;
    if (wide)
      pack<std::uint16_t>(row, alpha, tile.width, maximum, out);
    else if (alpha)
      pack<std::uint8_t>(row, alpha, tile.width, maximum, out);
    else
      pack_rgb8(row, tile.width, out);
  }
}

}  // namespace sfumato::raster::inline SFUMATO_ISA
