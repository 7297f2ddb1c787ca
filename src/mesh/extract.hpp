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

/// What a TriangleMesh is made from.
struct ExtractSource {
  const Triangulation& mesh;
  const ChordStore& chords;
  const std::vector<VertexOrigin>& origins;
  const Lattice& lattice;
  const Numbering& numbering;
};

/// The numbered part of a triangulation as flat arrays, whose room is taken from `memory`. Errors:
/// limit (memory), cancelled. Cost: O(slots + pieces).
Result<TriangleMesh> extract(const Context& context, const ExtractSource& from,
                             TableMemory& memory);

/// Brings `out`, which `extract` made from `memory`, up to date in place. Numbers of triangles,
/// vertices and constraints that are still there stay; beside the numbers of its constraints it is
/// what `extract` would make.
///
/// changed   the slots that changed since then, new ones among them; all are numbered
/// Errors    limit (memory), cancelled; `out` is good for nothing then
/// Cost      O(changed + new vertices), and now and then that of moving to more room
Status update_extract(const Context& context, const ExtractSource& from,
                      std::span<const std::int32_t> changed, TableMemory& memory,
                      TriangleMesh& out);

}  // namespace sfumato::mesh
