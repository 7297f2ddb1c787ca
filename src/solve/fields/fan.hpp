#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace sfumato::solve {

/// Returns the spoke after h around h's origin, in the direction of positive turns; kNone at the
/// hull.
inline std::int32_t next_spoke(const mesh::TriangleMesh& mesh, std::uint32_t h) {
  return mesh.half_edge_twin[previous_half_edge(h)];
}

/// Returns the spoke before h; kNone at the hull.
inline std::int32_t previous_spoke(const mesh::TriangleMesh& mesh, std::uint32_t h) {
  const std::int32_t twin = mesh.half_edge_twin[h];
  if (twin == mesh::kNone) return mesh::kNone;
  return static_cast<std::int32_t>(next_half_edge(static_cast<std::uint32_t>(twin)));
}

/// The triangles around a vertex: spoke i is a half-edge that begins at the vertex; it belongs to
/// triangle spoke[i] / 3.
struct Fan {
  std::vector<std::uint32_t> spoke;  ///< in the direction of positive turns
  bool is_closed = false;            ///< goes all the way round; else from hull to hull

  /// Collects the fan of h's origin. An open fan begins at the hull. A closed one begins at the
  /// last seam met when going backwards round the vertex from h, or behind h if there is no seam.
  template <class IsSeam>
  void collect(const mesh::TriangleMesh& mesh, std::uint32_t h, IsSeam is_seam) {
    const auto start = static_cast<std::int32_t>(h);
    std::int32_t first = start, seam = mesh::kNone;
    is_closed = false;
    for (std::int32_t i = start; i != mesh::kNone && !is_closed;) {
      first = i;
      if (is_seam(static_cast<std::uint32_t>(i))) seam = i;
      i = previous_spoke(mesh, static_cast<std::uint32_t>(i));
      is_closed = i == start;
    }
    if (is_closed && seam != mesh::kNone) first = seam;
    spoke.clear();
    std::int32_t i = first;
    do {
      spoke.push_back(static_cast<std::uint32_t>(i));
      i = next_spoke(mesh, static_cast<std::uint32_t>(i));
    } while (i != mesh::kNone && i != first);
  }
};

}  // namespace sfumato::solve
