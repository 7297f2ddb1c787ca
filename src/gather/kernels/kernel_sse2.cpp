#include "gather/kernels/kernel.hpp"

namespace sfumato::gather {

bool gather_packets_sse2(const SceneView& scene, const PacketBatch& batch,
                         const PacketStack& stack) {
  return gather_packets<4>(scene, batch, stack);
}

}  // namespace sfumato::gather
