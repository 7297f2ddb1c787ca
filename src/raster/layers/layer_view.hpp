#pragma once

#include "raster/kernels/tile.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::raster {

/// Returns the map that makes the viewport fill the image, or the larger one of a window. Error:
/// bad_input (an empty viewport, or one so small that pixel coordinates would overflow).
Result<Affine> image_from_artboard(const Picture& picture, const RasterOptions& options);

/// Returns a view of the instance's layer, which must outlive the view.
LayerView view_instance(const Picture& picture, const PatchInstance& instance,
                        const Affine& image_from_artboard);

}  // namespace sfumato::raster
