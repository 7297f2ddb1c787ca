#pragma once

#include "gather/kernels/scene_layout.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::gather {

/// The exact gather of a batch of packets: kernel.hpp compiled for one instruction set. Returns
/// false where the stack is too small; results are then incomplete.
using PacketKernel = bool(const SceneView& scene, const PacketBatch& batch,
                          const PacketStack& stack);

PacketKernel gather_packets_sse2;  ///< 4 lanes to a register; also for processors other than x86
#if defined(__x86_64__)
PacketKernel gather_packets_avx2;
PacketKernel gather_packets_avx512;
#endif

inline PacketKernel* packet_kernel([[maybe_unused]] SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::avx512) return gather_packets_avx512;
  if (level == SimdLevel::avx2) return gather_packets_avx2;
#endif
  return gather_packets_sse2;
}

}  // namespace sfumato::gather
