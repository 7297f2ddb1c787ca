#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/image/picture.hpp"

namespace sfumato::tracing {

/// Adds to a drawing, above all items, the part of the picture that it misses: a layer of one
/// rectangle along the artboard's border, with a texture inside (a texel for each traced pixel),
/// blended by hard light. Hard light reaches every colour from every other colour, and half grey
/// changes nothing. The texture is half grey wherever the curves are right, and the grain of a
/// material stays in place if a curve below it is moved.
///
/// Where the picture is not opaque the layer shows nothing: a second texture is its opacity.
///
/// drawing   as it is when the layer lies on it; its artboard is the picture
/// psnr_db   how near the drawing is to the picture's opaque pixels then, as TraceState::psnr_db
/// Errors    limit (texels, textures, layers, curves; memory), cancelled
/// Cost      diffuse() and rasterize() of the drawing
Status add_texture(Context& context, const Picture& picture, Document& drawing, double& psnr_db);

}  // namespace sfumato::tracing
