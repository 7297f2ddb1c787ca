#pragma once

#include <cstdint>

namespace sfumato {

/// Half-edge 3t + k runs from corner k of triangle t to the next.
inline constexpr std::uint32_t kNoHalfEdge = ~std::uint32_t{0};

constexpr std::uint32_t next_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
constexpr std::uint32_t last_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

}  // namespace sfumato
