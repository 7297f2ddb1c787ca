#pragma once

#include "mesh/chords.hpp"
#include "mesh/triangulation.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Marks the triangles inside the frame (Triangle::inside): an odd number of frame chords separates
/// them from the hull. Errors: limit (memory), cancelled; internal where the frame is open. Cost:
/// O(triangles).
Status flood_inside(const Context& context, Triangulation& mesh, const ChordStore& chords);

}  // namespace sfumato::mesh
