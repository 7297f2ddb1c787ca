#pragma once

#include <string>

#include "base/context.hpp"
#include "cli/arguments.hpp"
#include "formats/read_document.hpp"

namespace sfumato::cli {

/// Reads a document of any format from the bytes of arguments.input, with the textures that it may
/// have, and reports the reader's warnings. Errors: bad_input, limit, out_of_memory.
Result<ReadDocument> read_given_document(Context& context, const DocumentArguments& arguments,
                                         const std::string& bytes);

}  // namespace sfumato::cli
