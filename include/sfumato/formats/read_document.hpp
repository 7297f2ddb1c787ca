#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato {

/// Reads a document of any format, by its root element: SVG (docs/format.md) or Orzan's XML
/// (docs/format-orzan.md); packed by gzip (.svgz) too. `file` names the input in messages.
/// `loader` may be null: then every file that the document refers to is an error.
/// Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_document(Context& context, std::string_view bytes,
                                   const std::string& file, const ResourceLoader* loader = nullptr);

}  // namespace sfumato
