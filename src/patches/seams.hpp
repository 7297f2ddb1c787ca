#pragma once

#include <cstdint>
#include <vector>

#include "gather/scene.hpp"
#include "mesh/triangle_mesh.hpp"

namespace sfumato::patches {

/// Where the picture may jump: the constrained edges with a side that is not open.
class Seams {
 public:
  Seams(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes);

  /// True for both half-edges of an edge that stops rays on either side.
  bool is_seam(std::uint32_t half_edge) const { return is_seam_[half_edge] != 0; }

  /// What the triangle of a constrained half-edge sees of it.
  const gather::Facing& facing(std::uint32_t half_edge) const { return facing_[index(half_edge)]; }

  /// True where the side that the half-edge's triangle sees has a colour of its own.
  bool has_color(std::uint32_t half_edge) const {
    return is_seam(half_edge) && facing(half_edge).kind == ShaderKind::curve_domain;
  }

 private:
  std::size_t index(std::uint32_t half_edge) const {
    const auto constraint = static_cast<std::uint32_t>(mesh_.half_edge_constraint[half_edge]);
    return 2 * std::size_t{constraint} +
           (mesh_.origin(half_edge) == mesh_.constraint[constraint].from ? 0 : 1);
  }

  const mesh::TriangleMesh& mesh_;
  std::vector<gather::Facing> facing_;  ///< 2 per constraint: along it, against it
  std::vector<std::uint8_t> is_seam_;   ///< per half-edge
};

}  // namespace sfumato::patches
