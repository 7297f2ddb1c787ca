#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd_level.hpp"
#include "raster/kernels/image_shader_row.hpp"
#include "sfumato/base/affine.hpp"

namespace sfumato::raster {

/// Texels are read four at a time: this many may be read past the last of a row.
inline constexpr std::size_t kTexelsReadPast = 3;

/// A level is used if the shorter side of a pixel is at most this many of its texels. A tent over
/// the texels of the next level, which are means of 2 × 2, weights the finer texels in steps; the
/// error of this falls with the square of this number and is below 2 code values of 255 for black
/// and white noise.
inline constexpr double kMostTexelsAcross = 14;

/// Largest area of a pixel in texels of the level that is used. At most 2 · 2 times as many texels
/// are summed, and the texels cut by the tent's border.
inline constexpr double kLargestFootprint = 512;

/// One axis of a level: texels [0, count), and the continuation beyond them.
struct TextureAxis {
  int count = 1;
  double period = 1;  ///< period of a repeating texture, texels
  bool repeats = false;

  /// Returns x reduced to [0, period), or moved near the texture if it does not repeat. NaN gives
  /// 0.
  double reduced(double x) const;
  /// Returns the texel at place i of the endless row of texels.
  int texel(int i) const;
};

/// A level of a texture, in the layout for kernels.
struct TextureSource {
  const std::uint16_t* texels = nullptr;
  TextureAxis x, y;
  bool opaque = true;

  const std::uint16_t* at(int row, int column) const {
    return texels + 4 * (static_cast<std::ptrdiff_t>(row) * x.count + column);
  }
};

/// A tent two pixels wide around a sample, in a level's coordinates: weight (1 - |across · d|) (1 -
/// |down · d|) where both are above 0, at distance d in texels.
struct TextureTent {
  Vec2 across, down;
  Vec2 reach;              ///< half of its bounds, texels
  double run[2] = {1, 1};  ///< 1 / across.x and 1 / down.x; 0 where those are almost 0
  double area = 1;
  double shorter_side = 1;
};

/// Points of a row: map(first + (i, 0)), 0 ≤ i < count, in texels of the level.
struct TextureRow {
  Affine map;
  Vec2 first;
  int count = 0;
};

/// The inner loops, compiled for one instruction set. All sets give the same bits.
struct TextureKernels {
  /// Interpolates by cubic convolution, kept within the range of the four texels around the point.
  void (*magnify)(const TextureSource& source, const TextureRow& points, const ShaderRow& out);

  /// Computes the mean under the tent. Precondition: its area is at most kLargestFootprint.
  void (*minify)(const TextureSource& source, const TextureTent& tent, const TextureRow& points,
                 const ShaderRow& out);
};

/// Returns the kernels of one instruction set (texture_isa.cpp).
const TextureKernels& texture_kernels(LaneCount<4>);
const TextureKernels& texture_kernels(LaneCount<8>);
const TextureKernels& texture_kernels(LaneCount<16>);

/// Returns the kernels of a level, which must not be above detected_simd_level().
inline const TextureKernels& texture_kernels(SimdLevel level) {
  return *pick_by_level(level, [](auto lanes) { return &texture_kernels(lanes); });
}

}  // namespace sfumato::raster
