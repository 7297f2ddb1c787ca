#pragma once

#include "gather/kernels/end_terms.hpp"
#include "gather/kernels/integrator.hpp"
#include "gather/kernels/packet_walk.hpp"

/// The exact gather of packets: colours at points.
namespace sfumato::gather::inline SFUMATO_ISA {

template <int W, int kChannels, bool kBlends>
bool walk_packets(const SceneView& scene, const PacketBatch& batch, const PacketStack& stack) {
  PacketWalk<Integrator<W, kChannels, kBlends>> walk(scene, stack);
  for (int i = 0; i < batch.count; ++i) {
    if (!walk.run(batch.packet[i], batch.result[i])) return false;
    EndTerms<W>(scene, batch.packet[i], batch.result[i]).add();
  }
  return true;
}

/// Gathers a batch of packets with W lanes to a register. Returns false where the stack is too
/// small.
template <int W>
bool gather_packets(const SceneView& scene, const PacketBatch& batch, const PacketStack& stack) {
  if (scene.blend) return walk_packets<W, kValueChannels, true>(scene, batch, stack);
  if (scene.base_channels > 3) return walk_packets<W, 4, false>(scene, batch, stack);
  return walk_packets<W, 3, false>(scene, batch, stack);
}

}  // namespace sfumato::gather::inline SFUMATO_ISA
