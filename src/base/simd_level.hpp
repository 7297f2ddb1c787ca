#pragma once

#include <type_traits>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// The lanes of a register of an instruction set: 4; 8 with AVX2; 16 with AVX-512.
template <int kCount>
using LaneCount = std::integral_constant<int, kCount>;

/// Returns pick(LaneCount) for the registers of a level, which must not be above
/// detected_simd_level().
template <class Pick>
auto pick_by_level([[maybe_unused]] SimdLevel level, const Pick& pick) {
#if defined(__x86_64__)
  if (level == SimdLevel::avx512) return pick(LaneCount<16>());
  if (level == SimdLevel::avx2) return pick(LaneCount<8>());
#endif
  return pick(LaneCount<4>());
}

}  // namespace sfumato
