#include "patches/seams.hpp"

namespace sfumato::patches {

Seams::Seams(const mesh::TriangleMesh& mesh, const curves::SegmentAttributes& attributes)
    : mesh_(mesh),
      facing_(2 * mesh.constraint.size()),
      is_seam_(mesh.half_edge_constraint.size(), 0) {
  const auto half_edge_count = static_cast<std::uint32_t>(mesh.half_edge_constraint.size());
  for (std::uint32_t h = 0; h < half_edge_count; ++h) {
    if (mesh.half_edge_constraint[h] == mesh::kNone) continue;
    facing_[index(h)] = gather::facing_color(mesh, attributes, h);
    if (facing_[index(h)].kind == ShaderKind::open) continue;
    is_seam_[h] = 1;
    if (const std::int32_t twin = mesh.half_edge_twin[h]; twin != mesh::kNone) is_seam_[twin] = 1;
  }
}

}  // namespace sfumato::patches
