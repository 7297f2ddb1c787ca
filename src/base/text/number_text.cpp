#include "base/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/text/ascii.hpp"
#include "base/text/exact_decimal.hpp"
#include "base/text/number.hpp"

namespace sfumato {
namespace {

constexpr int kDoubleDigits = 17;

#if defined(__cpp_lib_to_chars)

/// Shortens the exponent: "1e-07" → "1e-7", "1.5e+20" → "1.5e20".
std::string with_short_exponent(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t end = e + 1;
  const bool negative = text[end] == '-';
  while (end + 1 < text.size() && (text[end] == '+' || text[end] == '-' || text[end] == '0')) ++end;
  return text.substr(0, e) + (negative ? "e-" : "e") + text.substr(end);
}

/// Returns the shortest decimal that reads back as this float or double.
template <class Number>
std::string shortest(Number value) {
  if (value == 0) return "0";
  const Number magnitude = std::abs(value);
  const auto format = magnitude >= Number(1e-5) && magnitude < Number(1e9)
                          ? std::chars_format::fixed
                          : std::chars_format::scientific;
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr;
  return with_short_exponent(std::string(buffer.data(), end));
}

std::string rounded_text(double value, int digits) {
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  return std::string(buffer.data(), end);
}

std::string fixed_text(double value, int places) {
  std::array<char, 80> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, places)
                       .ptr;
  return std::string(buffer.data(), end);
}

#else

/// WebAssembly: avoids the tables of its C++ library, 130 kB.
template <class Number>
std::string shortest(Number value) {
  return value == 0 ? "0" : shortest_decimal(value);
}

std::string rounded_text(double value, int digits) {
  return value == 0 ? "0" : rounded_decimal(value, digits);
}

std::string fixed_text(double value, int places) {
  return fixed_decimal(value, places);
}

#endif

double parsed(const std::string& text) {
  return parse_number(text).value_or(0);
}

/// Returns the value rounded to this many significant decimal digits; the value itself if the
/// result is not a double.
double rounded(double value, int digits) {
  return parse_number(rounded_text(value, digits)).value_or(value);
}

/// Returns a double p with p / 100 == fraction, found near 100 · fraction; else 100 · fraction.
double percent_of(double fraction) {
  const double near = 100 * fraction;
  for (const double p : {near, std::nextafter(near, 0.0), std::nextafter(near, 1e9)}) {
    if (p / 100 == fraction) return p;
  }
  return near;
}

std::string channel_text(float channel) {
  const double percent = 100.0 * static_cast<double>(channel);
  for (int digits = 1; digits < kDoubleDigits; ++digits) {
    const double p = rounded(percent, digits);
    if (static_cast<float>(p / 100) == channel) return shortest(p) + '%';
  }
  return shortest(percent) + '%';
}

/// Returns the code value k with k / 255 == channel to the bit, or -1.
int code_of(float channel) {
  const long k = std::lround(channel * 255);
  return k >= 0 && k <= 255 && static_cast<float>(k) / 255.0f == channel ? static_cast<int>(k) : -1;
}

}  // namespace

std::string number_text(double value) {
  return shortest(value);
}

std::string number_text(float value) {
  // Read as a double first, a decimal next to the middle between two floats may become the wrong
  // float.
  std::string text = shortest(value);
  if (static_cast<float>(parsed(text)) == value) return text;
  return shortest(static_cast<double>(value));
}

std::string rounded_number_text(double value, int digits) {
  return shortest(rounded(value, digits));
}

std::string length_text(double length) {
  constexpr double kMostWhole = 1e9;
  if (length < kMostWhole) return number_text(length);
  return rounded_number_text(std::min(length, std::numeric_limits<double>::max()), 3);
}

std::string fixed_number_text(double value, int places) {
  return fixed_text(value, places);
}

std::string percent_text(double fraction) {
  double percent = percent_of(fraction);
  const double read = percent / 100;
  percent = percent_of(read);
  for (int digits = 1; digits < kDoubleDigits; ++digits) {
    const double p = rounded(percent, digits);
    if (p / 100 == read) return shortest(p);
  }
  return shortest(percent);
}

std::string color_text(const Rgb& color) {
  std::string hexadecimal = "#";
  for (const float channel : {color.r, color.g, color.b}) {
    const int code = code_of(channel);
    if (code < 0) {
      return "rgb(" + channel_text(color.r) + ' ' + channel_text(color.g) + ' ' +
             channel_text(color.b) + ')';
    }
    hexadecimal += {kHexDigits[code / 16], kHexDigits[code % 16]};
  }
  return hexadecimal;
}

std::string transform_text(const Affine& map) {
  const std::string translation = number_text(map.e) + ' ' + number_text(map.f) + ')';
  if (map == Affine{1, 0, 0, 1, map.e, map.f}) return "translate(" + translation;
  std::string text = "matrix(";
  for (const double entry : {map.a, map.b, map.c, map.d}) text += number_text(entry) + ' ';
  return text + translation;
}

}  // namespace sfumato
