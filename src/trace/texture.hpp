#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/picture.hpp"

namespace sfumato::tracing {

/// Adds to a drawing, above all that is there, what it misses of the picture: a layer of one
/// rectangle along the artboard's border that bears a texture inside, a texel to a pixel looked at,
/// and is blended by hard light. Hard light reaches every colour from every other, and half grey
/// leaves what lies below: that is the texture wherever curves are right, and the grain of a
/// material stays where a curve is moved below it.
///
/// Where the picture is not opaque the layer shows nothing: a second texture is its opacity.
///
/// drawing   as it is when the layer lies on it; its artboard is the picture
/// psnr_db   how near the drawing is to the picture's opaque pixels then, as TraceState::psnr_db
/// Errors    limit (texels, textures, layers, curves; memory), cancelled
/// Cost      diffuse() and rasterize() of the drawing
Status add_texture(Context& context, const Picture& picture, Document& drawing, double& psnr_db);

}  // namespace sfumato::tracing
