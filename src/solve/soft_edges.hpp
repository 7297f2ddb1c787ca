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
  FunctionRef<bool(std::uint32_t half_edge)> is_curve;  ///< true on constrained edges alone
  /// The radius of a fine blur at fraction u; 0: none. Precondition: a curve lies on the half-edge.
  FunctionRef<float(std::uint32_t half_edge, float u)> fine_radius;
  /// Whether the half-edge's triangle shows a blur by itself.
  FunctionRef<bool(std::uint32_t half_edge)> is_meshed;
};

/// The sides of edges with a fine blur, numbered for the layer of the triangles with keep[t]. Where
/// two edges of a face meet, the bisector of their angle separates their blurs; a blur reaches at
/// most half way to a neighbouring curve. The result is allocated from `memory`. Errors: limit
/// (memory), cancelled.
Result<std::vector<SoftEdge>> find_soft_edges(const Context& context,
                                              const mesh::TriangleMesh& mesh,
                                              const EdgeBlurs& blurs,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory);

}  // namespace sfumato::solve
