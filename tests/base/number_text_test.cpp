#include "base/text/number_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/text/number.hpp"

namespace sfumato {
namespace {

/// Returns word i of a fixed sequence of well mixed words.
std::uint64_t word(std::uint64_t i) {
  std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double unit_double(std::uint64_t i) {
  return static_cast<double>(word(i) >> 11) * 0x1p-53;
}

TEST(NumberText, is_short) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-12.0), "-12");
  EXPECT_EQ(number_text(100000.0), "100000");
  EXPECT_EQ(number_text(1e9), "1e9");
  EXPECT_EQ(number_text(1.5e20), "1.5e20");
  EXPECT_EQ(number_text(1e-7), "1e-7");
  EXPECT_EQ(number_text(1e100), "1e100");
  EXPECT_EQ(number_text(0.1f), "0.1");
  EXPECT_EQ(rounded_number_text(3.14159, 3), "3.14");
  EXPECT_EQ(rounded_number_text(0, 3), "0");
}

TEST(NumberText, reads_back_as_the_same_double) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const double value = std::bit_cast<double>(word(i));
    if (!std::isfinite(value) || std::abs(value) < std::numeric_limits<double>::min()) continue;
    EXPECT_EQ(parse_number(number_text(value)), value);
  }
}

TEST(NumberText, reads_back_as_the_same_float_by_way_of_a_double) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(word(i)));
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(static_cast<float>(parse_number(number_text(value)).value()), value);
  }
}

TEST(LengthText, is_a_number_however_large_the_length) {
  EXPECT_EQ(length_text(16384.5), "16384.5");
  EXPECT_EQ(length_text(1.23456e12), "1.23e12");
  EXPECT_EQ(length_text(std::numeric_limits<double>::max()), "1.7976931348623157e308");
  EXPECT_EQ(length_text(std::numeric_limits<double>::infinity()), "1.7976931348623157e308");
}

TEST(PercentText, reads_back_as_the_same_quotient) {
  EXPECT_EQ(percent_text(0.0), "0");
  EXPECT_EQ(percent_text(0.3), "30");
  EXPECT_EQ(percent_text(1.0), "100");
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const double fraction = 100 * unit_double(i) / 100;
    const double read = parse_number(percent_text(fraction)).value() / 100;
    EXPECT_EQ(read, fraction);
    EXPECT_EQ(percent_text(read), percent_text(fraction));
  }
}

TEST(PercentText, of_any_fraction_is_off_by_a_rounding_and_settles_at_once) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const double fraction = unit_double(i);
    const double read = parse_number(percent_text(fraction)).value() / 100;
    EXPECT_NEAR(read, fraction, 2e-16);
    EXPECT_EQ(percent_text(read), percent_text(fraction));
  }
}

TEST(ColorText, is_hexadecimal_for_every_code_value) {
  for (int k = 0; k < 256; ++k) {
    const float channel = static_cast<float>(k) / 255.0f;
    const std::string text = color_text({channel, 0, 1});
    ASSERT_EQ(text.size(), 7u);
    EXPECT_EQ(std::stoi(text.substr(1, 2), nullptr, 16), k);
    EXPECT_EQ(text.substr(3), "00ff");
    EXPECT_EQ(static_cast<float>(k / 255.0), channel);  // readers that divide doubles agree
  }
}

TEST(ColorText, is_a_percentage_for_what_lies_between_code_values) {
  EXPECT_EQ(color_text({0.125f, 0.03f, 0.04f}), "rgb(12.5% 3% 4%)");
  EXPECT_EQ(color_text({0, 0.5f, 1}), "rgb(0% 50% 100%)");
}

TEST(ColorText, reads_back_as_the_same_channel) {
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const auto channel = static_cast<float>(unit_double(i));
    const std::string text = color_text({channel, 0, 0});
    if (text.front() == '#') continue;
    const std::size_t end = text.find('%');
    const double percent = parse_number(text.substr(4, end - 4)).value();
    EXPECT_EQ(static_cast<float>(percent / 100), channel) << text;
    EXPECT_LE(end - 4, 14u) << text;  // nine digits, point and zeros
  }
}

}  // namespace
}  // namespace sfumato
