#include "base/text/utf8.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "base/text/json.hpp"

namespace sfumato {
namespace {

std::string encoded(char32_t code_point) {
  std::string text;
  append_utf8(text, code_point);
  return text;
}

TEST(Utf8, gives_back_every_character) {
  for (char32_t c = 0; c <= 0x10FFFF; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    const std::string text = encoded(c);
    std::string_view rest = text;
    ASSERT_EQ(take_code_point(rest), c);
    ASSERT_TRUE(rest.empty());
    ASSERT_EQ(valid_utf8(text), text);
  }
}

TEST(Utf8, surrogates_and_larger_numbers_are_no_characters) {
  EXPECT_TRUE(is_scalar_value(0));
  EXPECT_TRUE(is_scalar_value(0xD7FF));
  EXPECT_FALSE(is_scalar_value(0xD800));
  EXPECT_FALSE(is_scalar_value(0xDFFF));
  EXPECT_TRUE(is_scalar_value(0xE000));
  EXPECT_TRUE(is_scalar_value(0x10FFFF));
  EXPECT_FALSE(is_scalar_value(0x110000));
}

TEST(Utf8, each_byte_that_is_none_is_replaced) {
  const std::string r = encoded(kReplacement);
  EXPECT_EQ(valid_utf8("a\xff"
                       "b"),
            "a" + r + "b");
  EXPECT_EQ(valid_utf8("\xc0\xaf"), r + r);                  // overlong
  EXPECT_EQ(valid_utf8("\xe0\x80\xaf"), r + r + r);          // overlong
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), r + r + r);          // a surrogate
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), r + r + r + r);  // above U+10FFFF
  EXPECT_EQ(valid_utf8("\xe2\x82"), r + r);                  // cut short
  EXPECT_EQ(valid_utf8("\xe2\x82z"), r + r + "z");
}

TEST(Utf8, of_random_bytes_is_valid_and_stays_as_it_is) {
  std::mt19937 random(1);
  for (int turn = 0; turn < 2000; ++turn) {
    std::string bytes(random() % 40, '\0');
    for (char& c : bytes) c = static_cast<char>(random() % 4 ? 0x80 + random() % 128 : random());
    const std::string valid = valid_utf8(bytes);
    EXPECT_EQ(valid_utf8(valid), valid);
    const std::string shown = printable(bytes);
    EXPECT_EQ(printable(shown), shown);
    const std::string json = JsonWriter().value(bytes).text();
    EXPECT_EQ(printable(json), json);
  }
}

TEST(Printable, has_no_controls_and_no_changes_of_direction) {
  for (const char32_t c : {0x00, 0x07, 0x0A, 0x1B, 0x7F, 0x80, 0x9B, 0x9F, 0x61C, 0x200E, 0x200F,
                           0x2028, 0x202A, 0x202E, 0x2066, 0x2069}) {
    EXPECT_EQ(printable("a" + encoded(c) + "b"), "a?b");
  }
  EXPECT_EQ(printable("a\nb\x1b", "\n"), "a\nb?");
  EXPECT_EQ(printable("Zeichnung ä 漢 😀"), "Zeichnung ä 漢 😀");
}

TEST(Printable, json_escapes_what_it_would_lose) {
  EXPECT_EQ(JsonWriter().value("\x1b" + encoded(0x9B) + encoded(0x202E)).text(),
            R"("\u001b\u009b\u202e")");
}

}  // namespace
}  // namespace sfumato
