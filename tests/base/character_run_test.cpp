#include "base/text/character_run.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/text/ascii.hpp"

namespace sfumato::test {
namespace {

TEST(CharacterRuns, end_and_begin_at_the_first_other_character_wherever_it_stands) {
  for (std::size_t size = 0; size <= 3 * kRunBlock; ++size) {
    const std::string blanks(size, '\t');
    EXPECT_EQ(run_end(blanks, 0, is_ascii_blank), size);
    EXPECT_EQ(run_begin(blanks, is_ascii_blank), 0u);
    for (std::size_t other = 0; other < size; ++other) {
      std::string text = blanks;
      text[other] = '\v';
      EXPECT_EQ(run_end(text, 0, is_ascii_blank), other);
      EXPECT_EQ(run_end(text, other, is_ascii_blank), other);
      EXPECT_EQ(run_end(text, other + 1, is_ascii_blank), size);
      EXPECT_EQ(run_begin(text, is_ascii_blank), other + 1);
    }
  }
}

TEST(CharacterRuns, blanks_are_the_five_of_css) {
  for (int c = 0; c < 256; ++c) {
    const bool is_one = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
    EXPECT_EQ(is_ascii_blank(static_cast<char>(c)), is_one) << c;
  }
}

}  // namespace
}  // namespace sfumato::test
