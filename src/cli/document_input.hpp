#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::cli {

/// The bytes of an input, at most as many as a limit of the context says, if the budget has room
/// for them. The caller must charge them. what: in the plural, for the limit's error. Errors:
/// bad_input, limit, cancelled, out_of_memory.
Result<std::string> read_within(Context& context, const std::string& path,
                                std::size_t Limits::*limit, std::string_view what);

/// The bytes of a drawing, if the budget has room for them. The caller must charge them.
/// Errors: bad_input, limit, out_of_memory.
Result<std::string> read_drawing_text(Context& context, const std::string& path);

/// Reads the document of arguments.input, with the textures that it may use, and reports the
/// reader's warnings. Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments);

/// The reader's warnings and, if there is nothing to draw, which command or option helps.
std::vector<Diagnostic> warnings_of(const ReadDocument& read);

}  // namespace sfumato::cli
