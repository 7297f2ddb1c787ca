#pragma once

#include <cstdint>

namespace sfumato {

/// Half-edges of triangles in flat arrays: 3 t + k runs from corner k of triangle t to corner (k +
/// 1) % 3. Its triangle is half_edge / 3. An entry for a corner describes the origin of its
/// half-edge.
inline constexpr std::uint32_t kNoHalfEdge = ~std::uint32_t{0};

/// Returns the half-edge of the same triangle that begins where this one ends.
constexpr std::uint32_t next_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

/// Returns the half-edge of the same triangle that ends where this one begins. It begins at the
/// corner across.
constexpr std::uint32_t previous_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

}  // namespace sfumato
