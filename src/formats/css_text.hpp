#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sfumato {

/// A blank of CSS or XML.
inline bool is_css_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

/// Without the blanks of CSS and XML on both ends.
std::string_view css_trimmed(std::string_view text);

/// ASCII letters in lower case.
std::string css_lower(std::string_view text);

/// Takes from the front of `text` what stands before the first `separator` that is in no
/// parentheses and no quotes, and the separator with it; all of it where there is none.
std::string_view take_until(std::string_view& text, char separator);

/// The value of a property in the declarations of a style attribute ("a: b; c: d"): the last one of
/// that name, trimmed, without !important.
std::optional<std::string_view> css_declaration(std::string_view declarations,
                                                std::string_view property);

/// What stands between the parentheses of url(…), without quotes and blanks; nothing where the text
/// is not a url().
std::optional<std::string_view> css_url(std::string_view text);

}  // namespace sfumato
