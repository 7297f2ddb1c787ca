#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/options/arguments.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/formats/read_document.hpp"

namespace sfumato::cli {

/// Reads the bytes of an input, at most `most`, if the budget has room for them. The caller must
/// charge them. Errors: bad_input, limit, cancelled, out_of_memory.
Result<std::string> read_up_to(Context& context, const std::string& path, std::size_t most);

/// Reads the bytes of an input, at most as many as a limit of the context allows, if the budget has
/// room for them. The caller must charge them. what: a plural noun for the limit's error. Errors:
/// bad_input, limit, cancelled, out_of_memory.
Result<std::string> read_within(Context& context, const std::string& path,
                                std::size_t Limits::*limit, std::string_view what);

/// Reads the bytes of a drawing or of a solved picture, if the budget has room for them. The caller
/// must charge them. Errors: bad_input, limit, out_of_memory.
Result<std::string> read_any_text(Context& context, const std::string& path);

/// Returns whether these are the bytes of a solved picture.
bool is_solved(const std::string& bytes);

/// Returns the error for a solved picture where something else is expected: "a drawing".
Status no_solved_picture(std::string_view expected, const std::string& path);

/// Reads the bytes of a drawing, if the budget has room for them. The caller must charge them.
/// Errors: bad_input, limit, out_of_memory.
Result<std::string> read_drawing_text(Context& context, const std::string& path);

/// Reads the document of these bytes of arguments.input, as read_drawing() does.
Result<ReadDocument> read_drawing_of(Context& context, const DocumentArguments& arguments,
                                     const std::string& bytes);

/// Reads the document of arguments.input, with the textures that it may use, and reports the
/// reader's warnings. Errors: bad_input, limit, cancelled, out_of_memory.
Result<ReadDocument> read_drawing(Context& context, const DocumentArguments& arguments);

/// Returns the reader's warnings and, if there is nothing to draw, which command or option helps.
std::vector<Diagnostic> warnings_of(const ReadDocument& read);

}  // namespace sfumato::cli
