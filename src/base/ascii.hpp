#pragma once

#include <string>
#include <string_view>

namespace sfumato {

/// Whether c is a blank of CSS and XML.
inline bool is_ascii_blank(char c) {
  // A sum, because GCC turns alternatives into a lookup in a table of bits, which it cannot
  // vectorize.
  return ((c == ' ') + (c == '\t') + (c == '\n') + (c == '\r') + (c == '\f')) != 0;
}

/// The text without blanks of CSS and XML at both ends.
std::string_view ascii_trimmed(std::string_view text);

/// The text with its ASCII letters in lower case.
std::string ascii_lower(std::string_view text);

}  // namespace sfumato
