#pragma once

#include <string>
#include <string_view>

namespace sfumato::outputs {

/// Text as the content of an element or an attribute in double quotes; control characters, which
/// HTML does not allow, become blanks.
std::string escaped_html(std::string_view text);

/// Returns a script, a shader or a style sheet without its indentation, empty lines and the
/// comments that begin a line. Line breaks are kept. Precondition: no string or template spans
/// several lines.
std::string condensed(std::string_view source);

/// Turns a condensed ES module into a part of one script that is not a module: removes its imports
/// and makes its exports plain declarations. Preconditions: imports and exports begin a line, an
/// import renames nothing, imports and lists of exports end with a semicolon, and there is no
/// default export.
std::string script_of_module(std::string_view condensed_module);

/// Returns a condensed script without unnecessary blanks. Lines with a slash or a template stay as
/// they are, because text in them that looks like a string may not be one.
std::string squeezed(std::string_view condensed_script);

}  // namespace sfumato::outputs
