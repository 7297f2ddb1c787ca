#include "export/svg/svg_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sfumato::outputs {
namespace {

std::string number(double value, int power) {
  std::string text;
  append_number(text, value, power);
  return text;
}

std::string path(const std::vector<Vec2>& points) {
  std::string text;
  append_closed_path(text, points);
  return text;
}

TEST(SvgText, a_path_with_a_point_beyond_whole_numbers_is_left_out) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : {0x1p53, -0x1p53, 1e300, nan}) {
    EXPECT_EQ(path({{0, 0}, {far, 0}, {0, 5}}), "");
    EXPECT_EQ(path({{0, 0}, {5, 0}, {0, far}}), "");
  }
  EXPECT_NE(path({{0, 0}, {0x1p52, 0}, {0, 5}}), "");
}

TEST(SvgText, numbers_say_nothing_needless) {
  EXPECT_EQ(number(0, 0), "0");
  EXPECT_EQ(number(-0.4, 0), "0");
  EXPECT_EQ(number(0.5, -1), ".5");
  EXPECT_EQ(number(-0.05, -2), "-.05");
  EXPECT_EQ(number(12.300, -3), "12.3");
  EXPECT_EQ(number(1234567, 3), "1235000");
  EXPECT_EQ(number(-1200, 0), "-1200");
}

TEST(SvgText, signs_part_numbers) {
  std::string text;
  append_numbers(text, {3, 4}, 0);
  append_numbers(text, {-3, -4}, 0);
  EXPECT_EQ(text, "3 4-3-4");
}

TEST(SvgText, paths_are_relative_and_whole) {
  EXPECT_EQ(path({{10.2, 20}, {13, 16}, {18, 22}}), "M10 20l3-4 5 6z");
  EXPECT_EQ(path({{0, 0}, {0.1, 0.1}, {5, 0}, {5, 5}}), "M0 0l5 0 0 5z");
  EXPECT_EQ(path({{1, 1}, {1.2, 1}, {9, 9}}), "");
  EXPECT_EQ(path({}), "");
}

TEST(SvgText, ids_are_counted_in_letters) {
  EXPECT_EQ(short_id(0), "a");
  EXPECT_EQ(short_id(25), "z");
  EXPECT_EQ(short_id(26), "aa");
  EXPECT_EQ(short_id(26 + 26 * 26), "aaa");
}

TEST(SvgText, colours_take_the_short_form_where_they_can) {
  std::string text;
  append_color(text, 0x33, 0, 0xff);
  append_color(text, 0x34, 0, 0xff);
  EXPECT_EQ(text, "#30f#3400ff");
}

}  // namespace
}  // namespace sfumato::outputs
