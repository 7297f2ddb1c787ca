#pragma once

#include "export/glb/glb_file.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// A layer's mesh in units of its own frame, y up, relative to `origin` in that frame. Engines
/// interpolate its colours in linear light. The difference from the patches, in code values of 1,
/// is at most max_error, unless that would need sides shorter than smallest_side. A layer without
/// triangles gives an empty mesh. Errors: limit (memory), cancelled.
Result<GlbMesh> make_glb_layer(Context& context, const PatchLayer& layer, InterpolationSpace space,
                               Vec2 origin, double max_error, double smallest_side);

/// A rectangle of one colour in the frame of `box`, y up, relative to `origin`.
GlbMesh make_glb_box(const Box& box, Vec2 origin, const Rgb& color);

/// The same with a texture.
GlbMesh make_glb_picture(const Box& box, Vec2 origin);

}  // namespace sfumato::outputs
