#pragma once

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

}  // namespace sfumato
