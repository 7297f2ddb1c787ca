#pragma once

#include "export/glb/glb_file.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// A layer's mesh in units of its own frame, y up, about `origin` of that frame. Engines
/// interpolate its colours in linear light; in code values that differs from the patches by
/// max_error, of 1, at most, but patches are not cut into sides shorter than smallest_side. A layer
/// without triangles gives an empty mesh. Errors: limit (memory), cancelled.
Result<GlbMesh> make_glb_layer(Context& context, const PatchLayer& layer, InterpolationSpace space,
                               Vec2 origin, double max_error, double smallest_side);

/// A rectangle of the frame that `box` is in, y up, about `origin`: of one colour.
GlbMesh make_glb_box(const Box& box, Vec2 origin, const Rgb& color);

/// The same with a texture.
GlbMesh make_glb_picture(const Box& box, Vec2 origin);

}  // namespace sfumato::outputs
