#pragma once

#include "picture/field_source.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato {

/// rasterize() with the fields of every layer from `source`, at pixel centres: of the patches only
/// the area that they cover counts, no curve is antialiased, and there is no overlay. Every layer
/// must have an opacity field. Errors: those of the source too; bad_input also
/// where a layer has no opacity field or the source gives too few values.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options,
                        const picture::FieldSource& source);

}  // namespace sfumato
