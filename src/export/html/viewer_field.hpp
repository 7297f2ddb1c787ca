#pragma once

#include "export/html/viewer_mesh.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"

namespace sfumato::outputs {

/// Returns the quantization step of values in the viewer, code values of 1. The error of a node is
/// at most half of it, a quarter of an 8-bit step. Channels of a colour space need smaller steps,
/// because their dark values are spread out on the screen.
double viewer_step(InterpolationSpace space);

/// A field of a layer: which corners and edges share their nodes, then the differences of the
/// nodes' values from a prediction by previous ones (docs/viewer.md, "Fields"). Nodes of corners
/// come first, then nodes of edges, then of centres, each in the order of the triangles.
///
/// step  of the channels other than weights of shaders; weights have the step of code values.
/// Values that are not finite are written as 0; others are clamped to ±64. Errors: limit (memory),
/// cancelled. Cost: O(triangles); 16 bytes a node and channel.
Status write_field(Context& context, const PatchField& field, const ViewerMesh& mesh, double step,
                   ByteWriter& out);

}  // namespace sfumato::outputs
