#pragma once

#include "gather/kernels/row_layout.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::gather {

/// Finds the edges that the points of one packet see: row_kernel.hpp compiled for one instruction
/// set. Returns false where the stack is too small; the taker has then received only a part.
using RowKernel = bool(const SceneView& scene, const PacketInput& packet, const RowTaker& taker,
                       const PacketStack& stack);

RowKernel find_rows_sse2;  ///< 4 lanes to a register; also for processors other than x86
#if defined(__x86_64__)
RowKernel find_rows_avx2;
RowKernel find_rows_avx512;
#endif

inline RowKernel* row_kernel([[maybe_unused]] SimdLevel level) {
#if defined(__x86_64__)
  if (level == SimdLevel::avx512) return find_rows_avx512;
  if (level == SimdLevel::avx2) return find_rows_avx2;
#endif
  return find_rows_sse2;
}

}  // namespace sfumato::gather
