#pragma once

#include "export/html/viewer_mesh.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::outputs {

/// Distance of two values that the viewer can tell apart, code values of 1: a node is at most half
/// of it off, which is a quarter of an 8-bit step. A channel of a colour space needs smaller ones,
/// for its darks are spread out on the screen.
double viewer_step(InterpolationSpace space);

/// A field of a layer: which corners and edges share their nodes, then what the nodes' values miss
/// of a guess from those before them (docs/viewer.md, "Fields"). Nodes of corners come first, then
/// those of edges, then of centres, each in the order of the triangles.
///
/// step  of the channels that are no shader's weight; weights have that of code values.
/// Values that are not finite are written as 0, others cut to ±64.
/// Errors: limit (memory), cancelled. Cost: O(triangles); 16 bytes a node and channel.
Status write_field(Context& context, const PatchField& field, const ViewerMesh& mesh, double step,
                   ByteWriter& out);

}  // namespace sfumato::outputs
