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

/// The input from which a TriangleMesh is extracted.
struct ExtractSource {
  const Triangulation& mesh;
  const ChordStore& chords;
  const std::vector<VertexOrigin>& origins;
  const Lattice& lattice;
  const Numbering& numbering;
};

/// The numbered part of a triangulation as flat arrays, allocated from `memory`. Errors: limit
/// (memory), cancelled. Cost: O(slots + pieces).
Result<TriangleMesh> extract(const Context& context, const ExtractSource& from,
                             TableMemory& memory);

/// Updates in place `out`, which `extract` made from `memory`. Triangles, vertices and constraints
/// that still exist keep their numbers. Except for the numbers of constraints, and for some
/// without an edge or pieces after curves were inserted, the result is what `extract` would make.
///
/// changed   the slots that changed since then, including new ones; all are numbered
/// Errors    limit (memory), cancelled; `out` is unusable then
/// Cost      O(changed + new vertices), and occasionally the cost of moving to larger arrays
Status update_extract(const Context& context, const ExtractSource& from,
                      std::span<const std::int32_t> changed, TableMemory& memory,
                      TriangleMesh& out);

/// Makes `mesh`, a copy of `before` that update_extract has changed since, `before` again.
///
/// changed   the triangles that changed
/// Cost      O(changed)
void take_back(const TriangleMesh& before, std::span<const std::uint32_t> changed,
               TriangleMesh& mesh);

}  // namespace sfumato::mesh
