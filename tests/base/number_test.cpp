#include "base/text/number.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <string>

namespace sfumato {
namespace {

TEST(ParseNumber, reads_decimals_of_every_form) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("-12.5"), -12.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  EXPECT_EQ(parse_number("25E-2"), 0.25);
  EXPECT_EQ(parse_number(" \t7\r\n"), 7.0);
  EXPECT_EQ(parse_number("1.7976931348623157e308"), 1.7976931348623157e308);
}

TEST(ParseNumber, rounds_correctly) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(parse_number("2.2250738585072011e-308"), 2.2250738585072011e-308);
}

TEST(ParseNumber, takes_nothing_else) {
  for (const char* text :
       {"",    " ",    "+",   "-",        ".",   "e5",  "1e",  "1e+",   "1,5",  "0x10", "nan",
        "inf", "-inf", "NaN", "infinity", "1 2", "--1", "+-1", "1.2.3", "12px", "1f"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(ParseNumber, what_is_too_large_is_none) {
  EXPECT_EQ(parse_number("1e309"), std::nullopt);
  EXPECT_EQ(parse_number("-1e99999999999"), std::nullopt);
  EXPECT_EQ(parse_number("0.1e400"), std::nullopt);
  EXPECT_EQ(parse_number(std::string(400, '9')), std::nullopt);
  EXPECT_EQ(parse_number("00" + std::string(400, '9') + ".5"), std::nullopt);
}

TEST(ParseNumber, what_is_too_small_is_zero) {
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  EXPECT_EQ(parse_number("-1e-99999999999"), 0.0);
  EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
}

TEST(ParseNumber, does_not_know_the_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool has_locale = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  EXPECT_EQ(parse_number("1.5"), 1.5);
  std::setlocale(LC_ALL, before.c_str());
  if (!has_locale) GTEST_SKIP() << "locale de_DE.UTF-8 is not installed";
}

}  // namespace
}  // namespace sfumato
