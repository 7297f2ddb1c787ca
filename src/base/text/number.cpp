#include "base/text/number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#include "base/text/character_run.hpp"

namespace sfumato {
namespace {

/// Digits beyond this number do not change a double, and take time.
constexpr std::size_t kLongestNumber = std::size_t{1} << 20;

bool is_blank(char c) {
  // Uses a sum, like is_ascii_blank().
  return ((c == ' ') + (c == '\t') + (c == '\n') + (c == '\r')) != 0;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(run_end(text, 0, is_blank));
  return text.substr(0, run_begin(text, is_blank));
}

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && is_digit(text[i])) ++i;
  return i;
}

std::size_t skip_sign(std::string_view text, std::size_t i) {
  return i < text.size() && (text[i] == '+' || text[i] == '-') ? i + 1 : i;
}

/// Returns whether the text is exactly [+-] (digits [. digits] | . digits) [(e|E) [+-] digits].
bool is_decimal(std::string_view text) {
  std::size_t begin = skip_sign(text, 0);
  std::size_t i = skip_digits(text, begin);
  std::size_t digit_count = i - begin;
  if (i < text.size() && text[i] == '.') {
    begin = i + 1;
    i = skip_digits(text, begin);
    digit_count += i - begin;
  }
  if (digit_count == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    begin = skip_sign(text, i + 1);
    i = skip_digits(text, begin);
    if (i == begin) return false;
  }
  return i == text.size();
}

#if defined(__cpp_lib_to_chars)

/// Returns whether a number is too small for a double, not too large. Precondition: from_chars
/// called `decimal` out of range, so that it is not near 1.
bool is_tiny(std::string_view decimal) {
  const std::size_t exponent_at = decimal.find_first_of("eE");
  if (exponent_at != std::string_view::npos && exponent_at + 1 < decimal.size()) {
    return decimal[exponent_at + 1] == '-';
  }
  const std::size_t first = decimal.find_first_not_of("+-0");
  return first != std::string_view::npos && decimal[first] == '.';
}

std::optional<double> value_of(std::string_view decimal) {
  if (decimal.front() == '+') decimal.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  if (error == std::errc::result_out_of_range && is_tiny(decimal)) return 0.0;
  if (error != std::errc()) return std::nullopt;
  return value;
}

#else

/// WebAssembly: its C library has only the locale "C".
std::optional<double> value_of(std::string_view decimal) {
  const double value = std::strtod(std::string(decimal).c_str(), nullptr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

#endif

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::string_view decimal = trimmed(text);
  if (decimal.size() > kLongestNumber || !is_decimal(decimal)) return std::nullopt;
  return value_of(decimal);
}

}  // namespace sfumato
