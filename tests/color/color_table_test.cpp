// The syntax of colours that C++ and TypeScript share.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "formats/css/color.hpp"
#include "support/places.hpp"

namespace sfumato {
namespace {

void expect_as_in(const std::string& text, const std::string& expected) {
  const Result<css::Color> color = css::parse_color(text);
  if (expected == "error") {
    EXPECT_FALSE(color.ok()) << text;
    return;
  }
  ASSERT_TRUE(color.ok()) << to_string(color.status());
  std::istringstream values(expected);
  double r = -1, g = -1, b = -1, alpha = -1;
  std::string word;
  values >> r >> g >> b >> alpha;
  ASSERT_TRUE(values) << text << " | " << expected;
  values >> word;
  EXPECT_NEAR(color->color.r, r, 1e-5) << text;
  EXPECT_NEAR(color->color.g, g, 1e-5) << text;
  EXPECT_NEAR(color->color.b, b, 1e-5) << text;
  EXPECT_NEAR(color->alpha, alpha, 1e-5) << text;
  EXPECT_EQ(color->is_mapped, word == "mapped") << text;
}

TEST(ColorTable, is_what_the_parser_reads) {
  std::ifstream table(test::source_path("tests/color/colors.txt"));
  ASSERT_TRUE(table);
  int count = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.starts_with("//")) continue;
    const std::size_t mark = line.rfind(" | ");
    ASSERT_NE(mark, line.npos) << line;
    expect_as_in(line.substr(0, mark), line.substr(mark + 3));
    ++count;
  }
  EXPECT_GT(count, 150);
}

}  // namespace
}  // namespace sfumato
