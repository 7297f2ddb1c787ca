#pragma once

#include <string>

#include "base/context.hpp"
#include "cli/arguments.hpp"
#include "formats/read_document.hpp"

namespace sfumato::cli {

/// Reads the document of arguments.input, with the textures that it may have, and reports the
/// reader's warnings. Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments);

}  // namespace sfumato::cli
