#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/chords.hpp"
#include "mesh/lattice.hpp"
#include "mesh/numbering.hpp"
#include "mesh/refiner.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// The source of a TriangleMesh.
struct ExtractSource {
  const Triangulation& mesh;
  const ChordStore& chords;
  const std::vector<VertexOrigin>& origins;
  const Lattice& lattice;
  const Numbering& numbering;
};

/// Returns the numbered part of a triangulation as flat arrays, allocated from `memory`. Errors:
/// limit (memory), cancelled. Cost: O(slots + pieces).
Result<TriangleMesh> extract(const Context& context, const ExtractSource& from,
                             TableMemory& memory);

/// Updates in place `out`, which `extract` made from `memory`. Triangles, vertices and constraints
/// that still exist keep their numbers. The result is the one that `extract` would make, except for
/// the numbers of constraints, and for some without an edge or pieces after curves were inserted.
///
/// changed   the slots that changed since then, including new ones; all are numbered
/// Errors    limit (memory), cancelled; `out` is then unusable
/// Cost      O(changed + new vertices), and occasionally the cost of moving to larger arrays
Status update_extract(const Context& context, const ExtractSource& from,
                      std::span<const std::int32_t> changed, TableMemory& memory,
                      TriangleMesh& out);

/// Restores `mesh`, a copy of `before` that update_extract has changed, to `before`.
///
/// changed   the triangles that changed
/// Cost      O(changed)
void take_back(const TriangleMesh& before, std::span<const std::uint32_t> changed,
               TriangleMesh& mesh);

}  // namespace sfumato::mesh
