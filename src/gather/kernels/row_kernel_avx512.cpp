#if defined(__x86_64__)

#include "gather/kernels/row_kernel.hpp"

namespace sfumato::gather {

bool find_rows_avx512(const SceneView& scene, const PacketInput& packet, const RowTaker& taker,
                      const PacketStack& stack) {
  return find_rows<16>(scene, packet, taker, stack);
}

}  // namespace sfumato::gather

#endif
