#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato {

/// Draws a document without patches: gathers at every pixel centre and, with
/// RasterOptions::antialias, in every part of a pixel that curves cut. Use it as ground truth for
/// the patches of diffuse(). DiffuseOptions::exact_pixels does the same in two steps.
///
/// The viewport is `raster_options.viewport`, else `diffuse_options.viewport`, else the artboard.
/// `stats`, unless null, grows as in diffuse(), and each point that is gathered counts as a node.
/// The result has the same bits for any thread count and SIMD level.
///
/// Errors: bad_input (an invalid document or option), limit, cancelled, out_of_memory.
/// Cost: one gather per pixel and instance, and about two more where a curve cuts a pixel.
Result<Image> render_pixels(Context& context, const Document& document,
                            const DiffuseOptions& diffuse_options,
                            const RasterOptions& raster_options, DiffuseStats* stats = nullptr);

}  // namespace sfumato
