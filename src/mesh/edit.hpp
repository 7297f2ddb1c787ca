#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/chords.hpp"
#include "mesh/refiner.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Gives every constrained edge a chord of its own, with its part of the owners. Refinement cuts
/// edges and leaves chords as they are; an Arrangement needs chords that are edges. Afterwards all
/// vertices count as the arrangement's.
///
/// chords, origins   sealed, and of the mesh; both are replaced
/// budget            that of the chords
/// Errors            limit (memory), cancelled; all three are unusable then
/// Cost              O(triangles + pieces)
Status bake_chords(const Context& context, Budget& budget, Triangulation& mesh, ChordStore& chords,
                   std::vector<VertexOrigin>& origins);

/// Takes segments off their chords: those s that have is_removed[s]. Where nothing is left the edge
/// becomes free, and the mesh is constrained Delaunay again. Vertices stay; all triangles around
/// those of the segments count as changed.
///
/// chords   whose chords are edges
/// Errors   cancelled; mesh and chords are unusable then
/// Cost     O(chords), and that of the flips
Status take_segments_off(const Context& context, std::span<const std::uint8_t> is_removed,
                         Triangulation& mesh, ChordStore& chords);

}  // namespace sfumato::mesh
