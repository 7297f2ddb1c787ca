#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato {

/// A document made from an ordinary SVG.
struct ImportedSvg {
  Document document;                 ///< valid
  std::string title;                 ///< text of the drawing's `<title>`; empty: none
  std::vector<Diagnostic> warnings;  ///< the content that was left out, as ReadDocument::warnings
};

/// Draws the tiles of patterns and masks. Pass draw_document(): this module lies below diffusion
/// and cannot call it. Returns the artboard as `width` × `height` pixels, rgba8. Errors: any.
using TilePainter =
    FunctionRef<Result<Image>(Context& context, const Document& tile, int width, int height)>;

/// Makes diffusion curves from the fills, strokes and gradients of an ordinary SVG
/// (docs/import.md). The parameters are as in read_document(); gzip (.svgz) is unpacked here too.
///
/// A filled shape becomes curves along the boundary of its filled part, with its colour or gradient
/// on their right side, the inside. A shape that lies wholly on one opaque shape, which is visible
/// around it, joins the layer of that shape, and its curves get that shape's paint on their left;
/// for others the outside is transparent. Shapes that do not meet share layers. An element with a
/// mistake is left out with a warning. An SVG without a size gets the size of its shapes. A stroke
/// becomes its outline, filled. Groups, opacity and the order of painting are kept, and the curves
/// get the ids of their shapes. A vector pattern becomes a texture that `painter` draws, at the
/// resolution of the picture's own size. So does a mask, unless it is a clip or a single paint.
/// Without a painter these are left out with a warning.
///
/// Errors: bad_input, limit, cancelled, out_of_memory, and the errors of the loader and the
/// painter.
/// Cost: that of read_document(), and for each fill and stroke O(n log n) in the chords of its
/// outline and the pairs of chords whose boxes overlap. In the calling thread.
Result<ImportedSvg> import_svg(Context& context, std::string_view text, const std::string& file,
                               const ResourceLoader* loader = nullptr,
                               std::optional<TilePainter> painter = std::nullopt);

}  // namespace sfumato
