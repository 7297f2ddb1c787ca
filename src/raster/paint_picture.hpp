#pragma once

#include "base/context.hpp"
#include "base/image.hpp"
#include "base/status.hpp"
#include "picture/field_source.hpp"
#include "picture/picture.hpp"
#include "raster/rasterize.hpp"

namespace sfumato::raster {

/// rasterize(), with the fields of every layer from `source` where that is not null: of the patches
/// only the area that they cover counts then, and no curve is antialiased.
Result<Image> paint_picture(Context& context, const Picture& picture, const RasterOptions& options,
                            const picture::FieldSource* source);

}  // namespace sfumato::raster
