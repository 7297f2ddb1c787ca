#pragma once

#include <string>
#include <string_view>

namespace sfumato::outputs {

/// Text as the content of an element or an attribute in double quotes; control characters, which
/// HTML does not allow, become blanks.
std::string escaped_html(std::string_view text);

/// A script, a shader or a style sheet without its indentation, empty lines and the comments that
/// begin a line. Line breaks are kept. Precondition: no string or template spans several lines.
std::string condensed(std::string_view source);

/// A condensed ES module as a part of one script that is no module: without its imports, and what
/// it exports as plain declarations. Preconditions: imports and exports begin a line, an import
/// renames nothing, imports and lists of exports end with a semicolon, nothing is exported as the
/// default.
std::string script_of_module(std::string_view condensed_module);

/// A condensed script without the blanks that it can do without. Lines with a slash or a template
/// stay as they are: what looks like a string may be none there.
std::string squeezed(std::string_view condensed_script);

}  // namespace sfumato::outputs
