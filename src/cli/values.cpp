#include "cli/values.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "base/limits.hpp"

namespace sfumato::cli {
namespace {

struct NamedColor {
  std::string_view name;
  std::uint32_t code;  // 0xrrggbb
};

constexpr std::array<NamedColor, 17> kNamedColors{{
    {"aqua", 0x00ffff},
    {"black", 0x000000},
    {"blue", 0x0000ff},
    {"fuchsia", 0xff00ff},
    {"gray", 0x808080},
    {"green", 0x008000},
    {"grey", 0x808080},
    {"lime", 0x00ff00},
    {"maroon", 0x800000},
    {"navy", 0x000080},
    {"olive", 0x808000},
    {"purple", 0x800080},
    {"red", 0xff0000},
    {"silver", 0xc0c0c0},
    {"teal", 0x008080},
    {"white", 0xffffff},
    {"yellow", 0xffff00},
}};

/// The whole of `text` as a number in `base_or_format`; empty where anything is left over.
template <class Number, class Format>
std::optional<Number> parse_all(std::string_view text, Format base_or_format) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, base_or_format);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

Rgb color_from_code(std::uint32_t code) {
  const auto channel = [code](int shift) {
    return static_cast<float>((code >> shift) & 0xff) / 255.0f;
  };
  return {channel(16), channel(8), channel(0)};
}

std::optional<Rgb> parse_hexadecimal_color(std::string_view digits) {
  std::string six(digits);
  if (digits.size() == 3) {
    six = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  }
  if (six.size() != 6) return std::nullopt;
  const std::optional<std::uint32_t> code = parse_all<std::uint32_t>(six, 16);
  if (!code) return std::nullopt;
  return color_from_code(*code);
}

char to_lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const std::optional<double> value = parse_all<double>(text, std::chars_format::general);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<double> parse_positive(std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value || *value <= 0) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t lowest,
                                         std::uint64_t highest) {
  const std::optional<std::uint64_t> value = parse_all<std::uint64_t>(text, 10);
  if (!value || *value < lowest || *value > highest) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_count(std::string_view text, std::uint64_t highest) {
  constexpr std::pair<std::string_view, std::uint64_t> kUnits[] = {
      {"KiB", 1ull << 10}, {"MiB", 1ull << 20}, {"GiB", 1ull << 30},
      {"k", 1'000},        {"M", 1'000'000},    {"G", 1'000'000'000}};
  std::uint64_t unit = 1;
  for (const auto& [name, size] : kUnits) {
    if (!text.ends_with(name)) continue;
    text.remove_suffix(name.size());
    unit = size;
    break;
  }
  const std::optional<std::uint64_t> value = parse_whole(text, 0, highest / unit);
  return value ? std::optional(*value * unit) : std::nullopt;
}

std::optional<double> parse_fraction(std::string_view text) {
  const bool is_percentage = text.ends_with('%');
  if (is_percentage) text.remove_suffix(1);
  std::optional<double> value = parse_positive(text);
  if (value && is_percentage) *value /= 100;
  if (!value || *value <= 0 || *value > 1) return std::nullopt;
  return value;
}

std::optional<Box> parse_viewport(std::string_view text) {
  std::array<double, 4> number{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 3)) return std::nullopt;
    const std::optional<double> value = parse_number(text.substr(0, comma));
    if (!value || std::abs(*value) > limits::kCoordinate) return std::nullopt;
    number[i] = *value;
    text.remove_prefix(i == 3 ? text.size() : comma + 1);
  }
  const Box box{{number[0], number[1]}, {number[0] + number[2], number[1] + number[3]}};
  if (!(box.width() > 0 && box.height() > 0)) return std::nullopt;
  if (box.max.x > limits::kCoordinate || box.max.y > limits::kCoordinate) return std::nullopt;
  return box;
}

std::optional<Rgb> parse_color(std::string_view text) {
  if (text.starts_with('#')) return parse_hexadecimal_color(text.substr(1));
  const auto found = std::find_if(kNamedColors.begin(), kNamedColors.end(), [&](const auto& known) {
    return std::equal(text.begin(), text.end(), known.name.begin(), known.name.end(),
                      [](char a, char b) { return to_lower(a) == b; });
  });
  if (found == kNamedColors.end()) return std::nullopt;
  return color_from_code(found->code);
}

}  // namespace sfumato::cli
