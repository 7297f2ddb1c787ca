#pragma once

#include "mesh/triangle_mesh.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Checks a mesh exactly on its lattice: indices, orientation, adjacency, Euler's formula, that
/// each constraint is an edge with its two half-edges marked, total area, and that every free edge
/// is locally Delaunay. The status names the first violation. For tests and debug builds: O(n).
Status is_valid(const TriangleMesh& mesh);

}  // namespace sfumato::mesh
