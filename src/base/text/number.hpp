#pragma once

#include <optional>
#include <string_view>

namespace sfumato {

/// Returns whether c is a digit. Branchless, so that loops over characters can be vectorized.
constexpr bool is_digit(char c) {
  return (c >= '0') & (c <= '9');
}

/// Reads a decimal number: sign, digits, point, exponent, with optional blanks around it. The
/// result is independent of the locale and correctly rounded; a value that is too small becomes 0.
/// No value if the text is anything else, is longer than 2^20 characters, or is too large for a
/// double; never NaN or infinity.
std::optional<double> parse_number(std::string_view text);

}  // namespace sfumato
