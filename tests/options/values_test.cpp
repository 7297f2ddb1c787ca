#include "options/values.hpp"

#include <gtest/gtest.h>

namespace sfumato::options {
namespace {

TEST(ParseNumber, takes_decimal_numbers) {
  EXPECT_EQ(parse_number("12"), 12.0);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("1e-3"), 0.001);
}

TEST(ParseNumber, refuses_what_is_not_finite_or_not_all_a_number) {
  for (const char* text : {"", "nan", "NaN", "inf", "-inf", "1e999", "1 ", " 1", "1x", "0x10",
                           "1,5", "+-1", "--1", "+1", "1\t"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(ParsePositive, refuses_zero_and_below) {
  EXPECT_EQ(parse_positive("0.25"), 0.25);
  for (const char* text : {"0", "-0", "-1", "1e-999"}) EXPECT_FALSE(parse_positive(text)) << text;
}

TEST(ParseWhole, keeps_to_its_range) {
  EXPECT_EQ(parse_whole("1", 1, 8), 1u);
  EXPECT_EQ(parse_whole("8", 1, 8), 8u);
  EXPECT_EQ(parse_whole("010", 1, 16), 10u);
  EXPECT_EQ(parse_whole("18446744073709551615", 0, UINT64_MAX), UINT64_MAX);
  for (const char* text : {"0", "9", "-1", "1.0", "1e0", "", "0x2", "18446744073709551616"}) {
    EXPECT_FALSE(parse_whole(text, 1, 8)) << text;
  }
}

TEST(ParseFraction, takes_fractions_and_percentages) {
  EXPECT_EQ(parse_fraction("0.04"), 0.04);
  EXPECT_EQ(parse_fraction("4%"), 0.04);
  EXPECT_EQ(parse_fraction("100%"), 1.0);
  EXPECT_EQ(parse_fraction("1"), 1.0);
  for (const char* text : {"0", "0%", "101%", "1.01", "%", "4%%", "-4%", "nan%"}) {
    EXPECT_FALSE(parse_fraction(text)) << text;
  }
}

TEST(ParseViewport, takes_a_corner_and_a_size) {
  const std::optional<Box> box = parse_viewport("-10,5.5,20,30");
  ASSERT_TRUE(box);
  EXPECT_EQ(*box, (Box{{-10, 5.5}, {10, 35.5}}));
  EXPECT_TRUE(parse_viewport("-1e7,-1e7,2e7,2e7")) << "all that there is";
}

TEST(ParseViewport, refuses_what_has_no_area_or_not_four_numbers) {
  for (const char* text : {"0,0,0,10", "0,0,10,0", "0,0,-1,10", "0,0,10", "0,0,10,10,10", "0,0,,10",
                           "", ",,,", "nan,0,1,1", "0,0,1e308,1", "9e6,0,2e6,1", "1e7,0,1e-9,1"}) {
    EXPECT_FALSE(parse_viewport(text)) << text;
  }
}

TEST(ParseWindow, takes_a_corner_and_a_size_in_whole_pixels) {
  EXPECT_EQ(parse_window("0,7,20,1"), (PixelRect{0, 7, 20, 8}));
  EXPECT_TRUE(parse_window("0,0,16777216,16777216")) << "all that there is";
  EXPECT_TRUE(parse_window("16777215,16777215,1,1"));
}

TEST(ParseWindow, refuses_what_no_image_holds) {
  for (const char* text :
       {"0,0,0,10", "0,0,10,0", "-1,0,10,10", "0,-1,10,10", "0,0,10", "0,0,10,10,10", "0,0,,10", "",
        ",,,", "0.5,0,1,1", "1e3,0,1,1", "0,0,16777217,1", "16777216,0,1,1", "0,16777216,1,1",
        "99999999999999999999,0,1,1", " 0,0,1,1", "0, 0,1,1"}) {
    EXPECT_FALSE(parse_window(text)) << text;
  }
}

}  // namespace
}  // namespace sfumato::options
