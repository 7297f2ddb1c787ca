#include "gather/kernel.hpp"

#if defined(__x86_64__)
namespace sfumato::gather {

bool gather_packet_avx512(const SceneView& scene, const PacketInput& packet,
                          const PacketStack& stack, PacketSums& out) {
  return gather_packet<16>(scene, packet, stack, out);
}

}  // namespace sfumato::gather
#endif
