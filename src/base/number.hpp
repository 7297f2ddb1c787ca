#pragma once

#include <optional>
#include <string_view>

namespace sfumato {

/// Without a branch, so that loops over characters become vectors.
constexpr bool is_digit(char c) {
  return (c >= '0') & (c <= '9');
}

/// Reads a decimal number: sign, digits, point, exponent, with blanks around it. The locale plays
/// no part and the result is correctly rounded; what is too small becomes 0. Nothing where the text
/// is anything else, longer than 2^20 characters, or too large for a double: never NaN or infinity.
std::optional<double> parse_number(std::string_view text);

}  // namespace sfumato
