#pragma once

#include "base/simd_level.hpp"
#include "gather/kernels/scene_layout.hpp"

namespace sfumato::gather {

/// The exact gather of a batch of packets: kernel.hpp compiled for one instruction set. Returns
/// false where the stack is too small; results are then incomplete.
using PacketKernel = bool(const SceneView& scene, const PacketBatch& batch,
                          const PacketStack& stack);

/// Returns the kernel of one instruction set (kernel_isa.cpp).
PacketKernel* packet_kernel(LaneCount<4>);
PacketKernel* packet_kernel(LaneCount<8>);
PacketKernel* packet_kernel(LaneCount<16>);

/// Returns the kernel of a level, which must not be above detected_simd_level().
inline PacketKernel* packet_kernel(SimdLevel level) {
  return pick_by_level(level, [](auto lanes) { return packet_kernel(lanes); });
}

}  // namespace sfumato::gather
