#if defined(__x86_64__)

#include "gather/kernels/kernel.hpp"

namespace sfumato::gather {

bool gather_packets_avx512(const SceneView& scene, const PacketBatch& batch,
                           const PacketStack& stack) {
  return gather_packets<16>(scene, batch, stack);
}

}  // namespace sfumato::gather

#endif
