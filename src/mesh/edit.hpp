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

/// Gives every constrained edge a separate chord, with its part of the owners. Refinement cuts
/// edges and leaves chords unchanged; an Arrangement needs chords that are edges. Afterwards all
/// vertices count as the arrangement's.
///
/// chords, origins   sealed, and of the mesh; both are replaced
/// budget            that of the chords
/// Errors            limit (memory), cancelled; all three are then unusable
/// Cost              O(triangles + pieces)
Status bake_chords(const Context& context, Budget& budget, Triangulation& mesh, ChordStore& chords,
                   std::vector<VertexOrigin>& origins);

/// Removes segments from their chords: the segments s with is_removed[s]. An edge without a load
/// becomes free, and the mesh is constrained Delaunay again. Vertices stay; all triangles around
/// the vertices of the segments count as changed.
///
/// chords   whose chords are edges
/// Errors   cancelled; mesh and chords are then unusable
/// Cost     O(chords), and that of the flips
Status take_segments_off(const Context& context, std::span<const std::uint8_t> is_removed,
                         Triangulation& mesh, ChordStore& chords);

}  // namespace sfumato::mesh
