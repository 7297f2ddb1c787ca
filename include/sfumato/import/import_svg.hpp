#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato {

/// A document made from an ordinary SVG.
struct ImportedSvg {
  Document document;                 ///< valid
  std::string title;                 ///< text of the drawing's `<title>`; empty: none
  std::vector<Diagnostic> warnings;  ///< what was left out, as ReadDocument::warnings
};

/// Makes diffusion curves from the fills, strokes and gradients of an ordinary SVG
/// (docs/import.md). The parameters are those of read_document(); gzip (.svgz) is unpacked here
/// too.
///
/// A filled shape becomes curves along the boundary of what it fills, with its colour or gradient
/// on their right side, the inside. A shape that lies wholly on one opaque shape, which is in sight
/// around it, joins the layer of that one, whose paint its curves bear on their left; for others
/// the outside is transparent. A stroke becomes its outline, filled. Groups, opacity and the order
/// of painting are kept, and the curves bear the ids of their shapes.
///
/// Errors: bad_input, limit, cancelled, out_of_memory, and those of the loader.
/// Cost: that of read_document(), and for each fill and stroke O(n log n) in the chords of its
/// outline and the pairs of chords whose boxes overlap. In the calling thread.
Result<ImportedSvg> import_svg(Context& context, std::string_view text, const std::string& file,
                               const ResourceLoader* loader = nullptr);

}  // namespace sfumato
