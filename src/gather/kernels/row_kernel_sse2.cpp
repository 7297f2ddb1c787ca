#include "gather/kernels/row_kernel.hpp"

namespace sfumato::gather {

bool find_rows_sse2(const SceneView& scene, const PacketInput& packet, const RowTaker& taker,
                    const PacketStack& stack) {
  return find_rows<4>(scene, packet, taker, stack);
}

}  // namespace sfumato::gather
