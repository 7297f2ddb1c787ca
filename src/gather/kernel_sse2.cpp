#include "gather/kernel.hpp"

namespace sfumato::gather {

bool gather_packet_sse2(const SceneView& scene, const PacketInput& packet, const PacketStack& stack,
                        PacketSums& out) {
  return gather_packet<4>(scene, packet, stack, out);
}

}  // namespace sfumato::gather
