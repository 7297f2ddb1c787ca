#pragma once

#include <string>
#include <string_view>

namespace sfumato {

/// Returns whether c is a blank of CSS and XML.
inline bool is_ascii_blank(char c) {
  // Uses a sum, because GCC turns alternatives into a lookup in a table of bits, which it cannot
  // vectorize.
  return ((c == ' ') + (c == '\t') + (c == '\n') + (c == '\r') + (c == '\f')) != 0;
}

/// The hexadecimal digits, by their values.
inline constexpr char kHexDigits[] = "0123456789abcdef";
inline constexpr char kUpperHexDigits[] = "0123456789ABCDEF";

/// The hex_value() of a character that is not a hexadecimal digit.
inline constexpr int kNoHexDigit = -1;

/// Returns the value of a hexadecimal digit in either case, or kNoHexDigit.
int hex_value(char c);

/// Returns the text without blanks of CSS and XML at both ends.
std::string_view ascii_trimmed(std::string_view text);

/// Returns the text with its ASCII letters in lower case.
std::string ascii_lower(std::string_view text);

}  // namespace sfumato
