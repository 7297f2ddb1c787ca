#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/flatten.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::solve {

/// A layer's patch mesh and the curves on its edges.
struct BowedMesh {
  const mesh::TriangleMesh& mesh;
  const curves::FlatCurves& flat;                      ///< with bows
  FunctionRef<bool(std::uint32_t half_edge)> is_jump;  ///< whether colours may jump there
};

/// Returns the edges whose curves stray from them, numbered for the layer of the triangles with
/// keep[t]. On an edge with several curves the last one drawn counts. The result is allocated from
/// `memory`. Errors: limit (memory), cancelled. Cost: O(triangles).
Result<std::vector<CurveBow>> find_curve_bows(const Context& context, const BowedMesh& bowed,
                                              std::span<const std::uint8_t> keep,
                                              TableMemory& memory);

}  // namespace sfumato::solve
