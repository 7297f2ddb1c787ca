#include "options/values.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "base/text/ascii.hpp"
#include "base/text/number.hpp"
#include "sfumato/base/limits.hpp"
#include "sfumato/raster/rasterize.hpp"

namespace sfumato::options {
namespace {

/// Returns the whole of `text` as a whole number; empty if anything is left over.
std::optional<std::uint64_t> parse_all(std::string_view text) {
  std::uint64_t value{};
  const char* text_end = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), text_end, value);
  if (error != std::errc{} || end != text_end) return std::nullopt;
  return value;
}

/// Reads four values with commas between them. read(part, index, value) returns whether a part is
/// valid.
template <class Value, class Read>
bool read_list(std::string_view text, std::array<Value, 4>& values, const Read& read) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 3)) return false;
    if (!read(text.substr(0, comma), i, values[i])) return false;
    text.remove_prefix(i == 3 ? text.size() : comma + 1);
  }
  return true;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  // Unlike documents, options allow no blanks around a number and no plus sign before it.
  const auto may_begin = [](char c) { return is_digit(c) || c == '-' || c == '.'; };
  if (text.empty() || !may_begin(text.front()) || is_ascii_blank(text.back())) return std::nullopt;
  return sfumato::parse_number(text);
}

std::optional<double> parse_positive(std::string_view text) {
  const std::optional<double> value = parse_number(text);
  if (!value || *value <= 0) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t lowest,
                                         std::uint64_t highest) {
  const std::optional<std::uint64_t> value = parse_all(text);
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
  const bool is_read =
      read_list(text, number, [](std::string_view part, std::size_t i, double& out) {
        const std::optional<double> value = parse_number(part);
        // A size may reach from one end of the range to the other.
        const double most = (i < 2 ? 1 : 2) * limits::kCoordinate;
        out = value.value_or(0);
        return value && std::abs(*value) <= most;
      });
  if (!is_read) return std::nullopt;
  const Box box{{number[0], number[1]}, {number[0] + number[2], number[1] + number[3]}};
  if (!(box.width() > 0 && box.height() > 0)) return std::nullopt;
  if (box.max.x > limits::kCoordinate || box.max.y > limits::kCoordinate) return std::nullopt;
  return box;
}

std::optional<PixelRect> parse_window(std::string_view text) {
  std::array<int, 4> number{};
  const bool is_read = read_list(text, number, [](std::string_view part, std::size_t i, int& out) {
    const auto value = parse_whole(part, i < 2 ? 0 : 1, RasterWindow::kLargestSide);
    out = static_cast<int>(value.value_or(0));
    return value.has_value();
  });
  const PixelRect rect{number[0], number[1], number[0] + number[2], number[1] + number[3]};
  if (!is_read || std::max(rect.x1, rect.y1) > RasterWindow::kLargestSide) return std::nullopt;
  return rect;
}

}  // namespace sfumato::options
