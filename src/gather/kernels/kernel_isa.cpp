#include "gather/kernels/kernel.hpp"
#include "gather/kernels/kernel_entry.hpp"

namespace sfumato::gather {

PacketKernel* packet_kernel(LaneCount<SFUMATO_ISA_LANES>) {
  return gather_packets<SFUMATO_ISA_LANES>;
}

}  // namespace sfumato::gather
