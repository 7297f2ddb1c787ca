#pragma once

#include <string>
#include <string_view>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/formats/text/reading.hpp"

namespace sfumato {

/// Reads the native format: SVG with the namespace urn:sfumato:1 (docs/format.md), not packed by
/// gzip. `file` and `loader` are as in read_document(). Use read_document() unless the format is
/// known.
///
/// Errors: bad_input, limit, cancelled, out_of_memory, and the errors of the loader.
/// Cost: as read_document().
Result<ReadDocument> read_svg(Context& context, std::string_view text, const std::string& file,
                              const ResourceLoader* loader = nullptr);

}  // namespace sfumato
