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

/// What the fields of a layer say of the half-edges of its mesh.
struct EdgeBlurs {
  FunctionRef<bool(std::uint32_t half_edge)> is_curve;
  /// The radius of a fine blur at fraction u; 0: none. Of curves alone.
  FunctionRef<float(std::uint32_t half_edge, float u)> fine_radius;
  /// Whether the half-edge's triangle shows a blur by itself.
  FunctionRef<bool(std::uint32_t half_edge)> is_meshed;
};

/// The sides of edges with a fine blur, as they are in the layer of the triangles with keep[t].
/// Where two edges of a face meet, the line that halves the angle parts their blurs; where another
/// curve is near, half of the way to it is a blur's. Their room is taken from `memory`. Errors:
/// limit (memory), cancelled.
Result<std::vector<SoftEdge>> find_soft_edges(const Context& context,
                                              const mesh::TriangleMesh& mesh,
                                              const EdgeBlurs& blurs,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory);

}  // namespace sfumato::solve
