#include "base/text/exact_decimal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace sfumato {
namespace {

constexpr std::uint64_t kLimb = 1'000'000'000;
constexpr std::size_t kLimbDigits = 9;

/// whole · 2^exponent.
struct Binary {
  std::uint64_t whole = 0;
  int exponent = 0;
};

/// 0.DIGITS · 10^point.
struct Decimal {
  std::string digits;
  int point = 0;
};

template <class Number>
Binary binary_of(Number magnitude) {
  constexpr int kBits = std::numeric_limits<Number>::digits;
  // Subnormal numbers have fewer bits, and the spacing of the smallest normal number.
  constexpr int kLowest = std::numeric_limits<Number>::min_exponent - kBits;
  const int exponent = std::max(std::ilogb(magnitude) - kBits + 1, kLowest);
  return {static_cast<std::uint64_t>(std::scalbn(magnitude, -exponent)), exponent};
}

void multiply(std::vector<std::uint32_t>& limbs, std::uint64_t factor) {
  std::uint64_t carry = 0;
  for (std::uint32_t& limb : limbs) {
    carry += limb * factor;
    limb = static_cast<std::uint32_t>(carry % kLimb);
    carry /= kLimb;
  }
  for (; carry > 0; carry /= kLimb) limbs.push_back(static_cast<std::uint32_t>(carry % kLimb));
}

void multiply_by_power(std::vector<std::uint32_t>& limbs, std::uint64_t base, int power) {
  constexpr int kStep = 13;  // 5^13 · 10^9 is below 2^63
  std::uint64_t step = 1;
  for (int i = 0; i < kStep; ++i) step *= base;
  for (; power >= kStep; power -= kStep) multiply(limbs, step);
  for (; power > 0; --power) multiply(limbs, base);
}

/// Returns the digits of whole · 2^exponent · 10^places, a whole number: places is max(-exponent,
/// 0).
std::string digits_of(const Binary& number) {
  std::vector<std::uint32_t> limbs;
  for (std::uint64_t rest = number.whole; rest > 0; rest /= kLimb) {
    limbs.push_back(static_cast<std::uint32_t>(rest % kLimb));
  }
  multiply_by_power(limbs, number.exponent < 0 ? 5 : 2, std::abs(number.exponent));
  std::string text(limbs.size() * kLimbDigits, '0');
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::uint32_t& limb = limbs[i / kLimbDigits];
    text[text.size() - 1 - i] = static_cast<char>('0' + limb % 10);
    limb /= 10;
  }
  return text.substr(std::min(text.find_first_not_of('0'), text.size()));
}

/// Adds one in the last place. Precondition: not only nines.
void count_up(std::string& digits) {
  std::size_t i = digits.size();
  while (digits[--i] == '9') digits[i] = '0';
  ++digits[i];
}

/// Returns whether `digits` without the first `kept` are nearer to the next number with that many
/// digits.
bool rounds_up(std::string_view digits, std::size_t kept) {
  const std::string_view rest = digits.substr(kept);
  if (rest.empty() || rest.front() != '5') return !rest.empty() && rest.front() > '5';
  if (rest.find_first_not_of('0', 1) != std::string_view::npos) return true;
  return kept > 0 && (digits[kept - 1] - '0') % 2 != 0;
}

/// The numbers that read back as one double: bounds and the double itself, as whole numbers of one
/// unit, with equally many digits.
struct Interval {
  std::string low, value, high;
  bool closed = false;

  bool holds(const std::string& digits) const {
    return closed ? low <= digits && digits <= high : low < digits && digits < high;
  }
};

template <class Number>
Interval interval_around(const Binary& number) {
  constexpr std::uint64_t kFirst = std::uint64_t{1} << (std::numeric_limits<Number>::digits - 1);
  constexpr int kLowest =
      std::numeric_limits<Number>::min_exponent - std::numeric_limits<Number>::digits;
  // Below a power of two the spacing of doubles is half as large.
  const bool closer_below = number.whole == kFirst && number.exponent > kLowest;
  const auto at = [&](std::uint64_t quarters) {
    return digits_of({quarters, number.exponent - 2});
  };
  const std::uint64_t quarters = 4 * number.whole;
  Interval result{at(quarters - (closer_below ? 1 : 2)), at(quarters), at(quarters + 2),
                  number.whole % 2 == 0};
  // A digit for count_up() to carry into.
  const std::size_t length = result.high.size() + 1;
  for (std::string* text : {&result.low, &result.value, &result.high}) {
    text->insert(0, length - text->size(), '0');
  }
  return result;
}

/// Returns the number of the interval with the most zeros at its end: the nearest one to the value.
std::string shortest_in(const Interval& interval) {
  const auto [low, high] = std::ranges::mismatch(interval.low, interval.high);
  for (auto kept = static_cast<std::size_t>(low - interval.low.begin());; ++kept) {
    std::string below = interval.value.substr(0, kept);
    std::string above = below;
    if (kept > 0) count_up(above);
    below.resize(interval.value.size(), '0');
    above.resize(interval.value.size(), '0');
    const bool up = rounds_up(interval.value, kept);
    if (interval.holds(up ? above : below)) return up ? above : below;
    if (interval.holds(up ? below : above)) return up ? below : above;
  }
}

/// Returns the decimal form. Precondition: `text` ends at the unit 10^exponent where exponent is
/// negative, else at 1.
Decimal decimal_of(std::string_view text, int exponent) {
  const std::size_t first = text.find_first_not_of('0');
  const std::size_t end = text.find_last_not_of('0') + 1;
  return {std::string(text.substr(first, end - first)),
          static_cast<int>(text.size() - first) + std::min(exponent, 0)};
}

std::string scientific(const Decimal& decimal) {
  std::string text = decimal.digits.substr(0, 1);
  if (decimal.digits.size() > 1) text += '.' + decimal.digits.substr(1);
  return text + 'e' + std::to_string(decimal.point - 1);
}

/// Writes a number without exponent. Precondition: not a whole number.
std::string fixed(Decimal decimal) {
  if (decimal.point <= 0) {
    return "0." + std::string(static_cast<std::size_t>(-decimal.point), '0') + decimal.digits;
  }
  return decimal.digits.insert(static_cast<std::size_t>(decimal.point), 1, '.');
}

template <class Number>
std::string shortest_text(Number value) {
  const Number magnitude = std::abs(value);
  const std::string sign = value < 0 ? "-" : "";
  if (magnitude < Number(1e9) && magnitude == std::floor(magnitude)) {
    return sign + std::to_string(static_cast<std::int64_t>(magnitude));
  }
  const Binary number = binary_of(magnitude);
  const std::string digits = shortest_in(interval_around<Number>(number));
  const Decimal decimal = decimal_of(digits, number.exponent - 2);
  const bool is_fixed = magnitude >= Number(1e-5) && magnitude < Number(1e9);
  return sign + (is_fixed ? fixed(decimal) : scientific(decimal));
}

}  // namespace

std::string shortest_decimal(double value) {
  return shortest_text(value);
}

std::string shortest_decimal(float value) {
  return shortest_text(value);
}

std::string rounded_decimal(double value, int digits) {
  const Binary number = binary_of(std::abs(value));
  std::string text = '0' + digits_of(number);
  const std::size_t kept = std::min(text.size(), static_cast<std::size_t>(digits) + 1);
  std::string rounded = text.substr(0, kept);
  if (rounds_up(text, kept)) count_up(rounded);
  rounded.resize(text.size(), '0');
  return (value < 0 ? "-" : "") + scientific(decimal_of(rounded, number.exponent));
}

std::string fixed_decimal(double value, int places) {
  const Binary number = value == 0 ? Binary{} : binary_of(std::abs(value));
  std::string text = '0' + digits_of(number);
  const auto had = static_cast<std::size_t>(std::max(-number.exponent, 0));
  const auto wanted = static_cast<std::size_t>(places);
  text.append(wanted - std::min(had, wanted), '0');
  const std::size_t after = std::max(had, wanted);
  // A digit before the point, and one for count_up() to carry into.
  if (text.size() < after + 2) text.insert(0, after + 2 - text.size(), '0');
  const std::size_t kept = text.size() - (after - wanted);
  std::string rounded = text.substr(0, kept);
  if (rounds_up(text, kept)) count_up(rounded);
  if (wanted > 0) rounded.insert(kept - wanted, 1, '.');
  const std::size_t last_zero = kept - wanted - 1;
  return (std::signbit(value) ? "-" : "") +
         rounded.substr(std::min(rounded.find_first_not_of('0'), last_zero));
}

}  // namespace sfumato
