#pragma once

#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::cli {

/// The bytes of an input, if the budget has room for them; who calls charges for them.
/// Errors: bad_input, limit, out_of_memory.
Result<std::string> read_drawing_text(Context& context, const std::string& path);

/// Reads the document of arguments.input, with the textures that it may have, and reports the
/// reader's warnings. Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments);

/// What the reader overlooked, and what of the command helps where it found nothing to draw.
std::vector<Diagnostic> warnings_of(const ReadDocument& read);

}  // namespace sfumato::cli
