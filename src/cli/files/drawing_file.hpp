#pragma once

#include <string>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::cli {

/// Writes a document as SVG, packed by gzip if the name ends in .svgz; "-" is standard output. The
/// caller has charged the document. Errors: as write_svg() and write_file().
Status write_drawing(Context& context, const Document& document, const std::string& output);

}  // namespace sfumato::cli
