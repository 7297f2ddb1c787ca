#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato {

/// A document made of an ordinary SVG, and what could not be brought over, each with its place.
struct ImportedSvg {
  Document document;
  std::string title;
  std::vector<Diagnostic> warnings;
};

/// Makes diffusion curves of the fills, strokes and gradients of an ordinary SVG (docs/import.md).
/// A filled shape becomes curves along the boundary of what it fills: its colour or gradient is on
/// their right, the inside. Where it lies wholly on one opaque shape, in sight, it joins that one's
/// layer and has its paint on the left; else the outside is transparent. A stroke is its outline,
/// filled. Groups, opacity and the order of painting are kept, and the curves bear the ids of their
/// shapes. Packed by gzip too (.svgz).
///
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<ImportedSvg> import_svg(Context& context, std::string_view text, const std::string& file,
                               const ResourceLoader* loader = nullptr);

}  // namespace sfumato
