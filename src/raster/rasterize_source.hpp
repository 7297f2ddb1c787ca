#pragma once

#include "picture/field_source.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato {

/// Does rasterize() with the fields of every layer from `source`, at pixel centres. The patches
/// determine only the covered area, no curve is antialiased, and there is no overlay. Every layer
/// must have an opacity field. Errors: as rasterize() and the source; bad_input also if a layer has
/// no opacity field or the source returns too few values.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options,
                        const picture::FieldSource& source);

}  // namespace sfumato
