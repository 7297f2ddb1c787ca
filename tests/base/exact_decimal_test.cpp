#include "base/text/exact_decimal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "base/text/number_text.hpp"

namespace sfumato {
namespace {

std::string rounded_by_the_library(double value, int digits) {
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  return {buffer.data(), end};
}

double read(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Calls `check` for numbers of every exponent: powers of two and their neighbours, and short
/// numbers.
template <class Number, class Bits, class Check>
void for_many(const Check& check) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const auto value = std::bit_cast<Number>(static_cast<Bits>(random()));
    if (std::isfinite(value) && value != 0) check(value);
    check(static_cast<Number>(static_cast<double>(random() % 2'000'000 + 1) / 1000));
  }
  using Limits = std::numeric_limits<Number>;
  for (int e = Limits::min_exponent - Limits::digits; e < Limits::max_exponent; ++e) {
    const Number power = std::ldexp(Number(1), e);
    check(power);
    check(-std::nextafter(power, Limits::infinity()) / 2);
    if (power > Limits::denorm_min()) check(std::nextafter(power, Number(0)));
  }
  check(Limits::max());
}

TEST(ExactDecimal, gives_the_shortest_text_of_a_double) {
  for_many<double, std::uint64_t>([](double value) {
    if (value == 0) return;
    ASSERT_EQ(shortest_decimal(value), number_text(value));
  });
}

TEST(ExactDecimal, gives_the_shortest_text_of_a_float) {
  for_many<float, std::uint32_t>([](float value) {
    if (value == 0) return;
    const std::string text = shortest_decimal(value);
    // number_text() may choose a longer text that reads back through a double.
    if (static_cast<float>(read(text)) != value) return;
    ASSERT_EQ(text, number_text(value));
  });
}

TEST(ExactDecimal, rounds_to_significant_digits) {
  for_many<double, std::uint64_t>([](double value) {
    if (value == 0) return;
    for (const int digits : {1, 2, 5, 15, 17}) {
      ASSERT_EQ(read(rounded_decimal(value, digits)), read(rounded_by_the_library(value, digits)))
          << value << " to " << digits;
    }
  });
  EXPECT_EQ(rounded_decimal(2.5, 1), "2e0");
  EXPECT_EQ(rounded_decimal(3.5, 1), "4e0");
  EXPECT_EQ(rounded_decimal(-999.6, 3), "-1e3");
}

TEST(ExactDecimal, rounds_to_places) {
  for_many<double, std::uint64_t>([](double value) {
    if (std::fabs(value) > 1e40) return;
    for (const int places : {0, 3, 18}) {
      ASSERT_EQ(fixed_decimal(value, places), fixed_number_text(value, places))
          << value << " to " << places;
    }
  });
  EXPECT_EQ(fixed_decimal(0, 2), "0.00");
  EXPECT_EQ(fixed_decimal(0.5, 0), "0");
  EXPECT_EQ(fixed_decimal(-1.5, 0), "-2");
  EXPECT_EQ(fixed_decimal(9.996, 2), "10.00");
  EXPECT_EQ(fixed_decimal(-0.001, 2), "-0.00");
}

}  // namespace
}  // namespace sfumato
