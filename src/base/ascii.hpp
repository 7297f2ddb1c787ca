#pragma once

#include <string>
#include <string_view>

namespace sfumato {

/// A blank of CSS or XML.
inline bool is_ascii_blank(char c) {
  // A sum: of alternatives GCC makes a table of bits, which no vector instruction looks up.
  return ((c == ' ') + (c == '\t') + (c == '\n') + (c == '\r') + (c == '\f')) != 0;
}

/// Without the blanks of CSS and XML on both ends.
std::string_view ascii_trimmed(std::string_view text);

/// ASCII letters in lower case.
std::string ascii_lower(std::string_view text);

}  // namespace sfumato
