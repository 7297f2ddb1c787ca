#include "export/svg/svg_text.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/ascii.hpp"
#include "base/text/number_text.hpp"

namespace sfumato::outputs {
namespace {

/// Below this every whole number is a double.
constexpr double kWholeNumbersEnd = 0x1p53;

bool is_writable(Vec2 p) {
  return std::fabs(p.x) < kWholeNumbersEnd && std::fabs(p.y) < kWholeNumbersEnd;
}

double power_of_ten(int power) {
  return std::pow(10.0, power);
}

}  // namespace

void append_number(std::string& text, double value, int power) {
  std::int64_t steps = std::llround(value * power_of_ten(-power));
  if (steps == 0) {
    text += '0';
    return;
  }
  for (; steps % 10 == 0; ++power) steps /= 10;
  if (steps < 0) text += '-';
  std::string digits = std::to_string(std::abs(steps));
  if (power < 0) {
    const auto decimals = static_cast<std::size_t>(-power);
    if (digits.size() < decimals) digits.insert(0, decimals - digits.size(), '0');
    digits.insert(digits.size() - decimals, 1, '.');
  } else {
    digits.append(static_cast<std::size_t>(power), '0');
  }
  text += digits;
}

void append_numbers(std::string& text, Vec2 values, int power) {
  append_number(text, values.x, power);
  const std::size_t second = text.size();
  append_number(text, values.y, power);
  if (text[second] != '-') text.insert(second, 1, ' ');
}

void append_closed_path(std::string& text, std::span<const Vec2> points) {
  if (!std::ranges::all_of(points, is_writable)) return;
  const std::size_t begin = text.size();
  std::size_t steps = 0;
  Vec2 last;
  for (const Vec2 point : points) {
    const Vec2 p{std::round(point.x), std::round(point.y)};
    if (text.size() == begin) {
      text += 'M';
      append_numbers(text, p, 0);
    } else if (!(p == last)) {
      const Vec2 step = p - last;
      if (steps == 0) text += 'l';
      const std::size_t number = text.size();
      append_numbers(text, step, 0);
      if (steps++ > 0 && text[number] != '-') text.insert(number, 1, ' ');
    }
    last = p;
  }
  if (steps < 2) {
    text.resize(begin);
  } else {
    text += 'z';
  }
}

std::string short_id(std::uint64_t number) {
  std::string id;
  for (++number; number > 0; number /= 26) {
    --number;
    id += static_cast<char>('a' + number % 26);
  }
  std::ranges::reverse(id);
  return id;
}

void append_color(std::string& text, int r, int g, int b) {
  const bool is_short = r % 17 == 0 && g % 17 == 0 && b % 17 == 0;
  text += '#';
  for (const int channel : {r, g, b}) {
    text += kHexDigits[channel >> 4 & 15];
    if (!is_short) text += kHexDigits[channel & 15];
  }
}

std::string transform_attribute(const Affine& map) {
  if (map == Affine{}) return {};
  return " transform=\"" + transform_text(map) + '"';
}

}  // namespace sfumato::outputs
