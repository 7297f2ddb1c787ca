#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Draws the artboard of a document, rgba8: calls diffuse() for that size, then rasterize(). Pass
/// it to import_svg() as its painter.
///
/// Errors: as diffuse() and rasterize().
Result<Image> draw_document(Context& context, const Document& document, int width, int height);

}  // namespace sfumato
