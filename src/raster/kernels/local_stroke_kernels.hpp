#pragma once

#include <cstdint>
#include <span>

#include "base/simd_level.hpp"
#include "curves/stroke_segments.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::raster {

/// A stroke is evaluated in blocks of pixels whose corners are multiples of this, for every painted
/// rectangle.
inline constexpr int kStrokeBlockWidth = 16;
inline constexpr int kStrokeBlockHeight = 8;

/// W and W Z of the pixels of a block (eq. 12–13); `finish` turns them into opacity and sRGB
/// colour.
struct StrokeSums {
  float weight[kStrokeBlockHeight][kStrokeBlockWidth];
  float color[3][kStrokeBlockHeight][kStrokeBlockWidth];
};

/// Data common to all blocks of a stroke. The frame is that of its segments.
struct StrokeFrame {
  float frame_from_image[2][2] = {};  ///< linear part: rows x, y; columns of the image's x, y
  float image_from_frame[2][2] = {};
  float reach_per_radius[2] = {};  ///< half the bounds of a unit circle in the image, pixels
  float smallest_radius = 1;
  float alpha = 1;
  bool two_sided = false;  ///< the colours of the two sides differ somewhere
  InterpolationSpace interpolation = InterpolationSpace::srgb;
};

/// The inner loops, compiled for one instruction set. All sets give the same bits.
struct StrokeKernels {
  /// Adds the named segments, in order, to the sums of the block with `center` (frame).
  void (*add_segments)(const StrokeFrame& frame, const curves::StrokeSegment* segments,
                       std::span<const std::uint32_t> indices, Vec2 center, StrokeSums& sums);

  /// weight ← min(1, alpha W); color ← Z as sRGB code values.
  void (*finish)(const StrokeFrame& frame, StrokeSums& sums);
};

/// Returns the kernels of one instruction set (local_stroke_isa.cpp).
const StrokeKernels& stroke_kernels(LaneCount<4>);
const StrokeKernels& stroke_kernels(LaneCount<8>);
const StrokeKernels& stroke_kernels(LaneCount<16>);

/// Returns the kernels of a level, which must not be above detected_simd_level().
inline const StrokeKernels& stroke_kernels(SimdLevel level) {
  return *pick_by_level(level, [](auto lanes) { return &stroke_kernels(lanes); });
}

}  // namespace sfumato::raster
