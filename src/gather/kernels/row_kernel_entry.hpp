#pragma once

#include "base/simd_level.hpp"
#include "gather/kernels/row_layout.hpp"

namespace sfumato::gather {

/// Finds the edges that the points of one packet see: row_kernel_isa.cpp compiled for one
/// instruction set. Returns false where the stack is too small; the taker has then received only a
/// part.
using RowKernel = bool(const SceneView& scene, const PacketInput& packet, const RowTaker& taker,
                       const PacketStack& stack);

/// Returns the kernel of one instruction set (row_kernel_isa.cpp).
RowKernel* row_kernel(LaneCount<4>);
RowKernel* row_kernel(LaneCount<8>);
RowKernel* row_kernel(LaneCount<16>);

/// Returns the kernel of a level, which must not be above detected_simd_level().
inline RowKernel* row_kernel(SimdLevel level) {
  return pick_by_level(level, [](auto lanes) { return row_kernel(lanes); });
}

}  // namespace sfumato::gather
