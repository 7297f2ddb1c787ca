#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::solve {

/// Blur of the half-edges of a layer's mesh, from the layer's fields.
struct EdgeBlurs {
  std::span<const std::uint8_t> is_curve;  ///< per half-edge: 1 only on constrained edges
  std::span<const std::uint32_t> fine;     ///< half-edges that may have a fine blur, ascending
  /// Returns the radius of a fine blur at fraction u of one of these; 0: none.
  FunctionRef<float(std::uint32_t half_edge, float u)> fine_radius;
  /// Returns whether the half-edge's triangle shows a blur in its mesh.
  FunctionRef<bool(std::uint32_t half_edge)> is_meshed;
};

/// Returns the sides of edges with a fine blur, numbered for the layer of the triangles with
/// keep[t], or of all if `keep` is empty. Where two edges of a face meet, the bisector of their
/// angle separates their blurs; a blur reaches at most half way to a neighbouring curve. The result
/// is allocated from `memory`. Errors: limit (memory), cancelled.
Result<std::vector<SoftEdge>> find_soft_edges(const Context& context,
                                              const mesh::TriangleMesh& mesh,
                                              const EdgeBlurs& blurs,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory);

/// Returns whether a corner c of the triangle has is_near[c].
bool touches(const mesh::TriangleMesh& mesh, std::uint32_t triangle,
             std::span<const std::uint8_t> is_near);

/// Updates the soft edges of a mesh that changed, where all triangles are kept.
///
/// blurs     its `fine` lists only half-edges of triangles near the change
/// before    of the mesh before the change
/// is_near   per vertex: 1 at the corners of triangles that changed
Result<std::vector<SoftEdge>> update_soft_edges(
    const Context& context, const mesh::TriangleMesh& mesh, const EdgeBlurs& blurs,
    std::span<const SoftEdge> before, std::span<const std::uint8_t> is_near, TableMemory& memory);

}  // namespace sfumato::solve
