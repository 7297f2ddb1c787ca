#include "base/text/ascii.hpp"

#include <gtest/gtest.h>

namespace sfumato {
namespace {

TEST(Ascii, every_hexadecimal_digit_has_its_value) {
  for (int value = 0; value < 16; ++value) {
    EXPECT_EQ(hex_value(kHexDigits[value]), value);
    EXPECT_EQ(hex_value(kUpperHexDigits[value]), value);
  }
}

TEST(Ascii, no_other_character_is_a_hexadecimal_digit) {
  int digit_count = 0;
  for (int c = 0; c < 256; ++c) digit_count += hex_value(static_cast<char>(c)) != kNoHexDigit;
  EXPECT_EQ(digit_count, 10 + 6 + 6);
}

}  // namespace
}  // namespace sfumato
