#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

/// Document → Image with no patches: the gather at every pixel centre, the ground
/// truth that the sparse picture is held against. The colour of a pixel is that of its centre:
/// there is no antialiasing, and `antialias` and `mesh_overlay` are ignored.
///
/// raster_options.viewport defaults to diffuse_options.viewport, and that to the artboard.
/// stats  optional: as of `diffuse`, where nodes are the pixels; there are no triangles.
/// Errors: bad_input (an invalid document), limit, cancelled. The same bits for any thread count
/// and SIMD level. Cost: one gather per pixel.
Result<Image> render_pixels(Context& context, const Document& document,
                            const DiffuseOptions& diffuse_options,
                            const RasterOptions& raster_options, DiffuseStats* stats = nullptr);

}  // namespace sfumato
