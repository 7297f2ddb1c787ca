// Colours in CSS notation.
#include <gtest/gtest.h>

#include "formats/css/color.hpp"
#include "formats/css/names.hpp"

namespace sfumato {
namespace {

void expect_color(const char* text, double r, double g, double b, double alpha = 255) {
  const Result<css::Color> color = css::parse_color(text);
  ASSERT_TRUE(color.ok()) << text << ": " << to_string(color.status());
  EXPECT_NEAR(255 * color->color.r, r, 0.01) << text;
  EXPECT_NEAR(255 * color->color.g, g, 0.01) << text;
  EXPECT_NEAR(255 * color->color.b, b, 0.01) << text;
  EXPECT_NEAR(255 * color->alpha, alpha, 0.01) << text;
}

TEST(CssColor, names) {
  expect_color("gold", 255, 215, 0);
  expect_color(" RebeccaPurple ", 102, 51, 153);
  expect_color("aliceblue", 240, 248, 255);
  expect_color("yellowgreen", 154, 205, 50);
  expect_color("transparent", 0, 0, 0, 0);
}

TEST(CssColor, every_name_is_found) {
  for (const css::NamedColor& color : css::kNamedColors) {
    EXPECT_TRUE(css::parse_color(color.name).ok()) << color.name;
  }
}

TEST(CssColor, hexadecimal_of_three_four_six_and_eight_digits) {
  expect_color("#c21", 204, 34, 17);
  expect_color("#C218", 204, 34, 17, 136);
  expect_color("#dfe9f2", 223, 233, 242);
  expect_color("#dfe9f240", 223, 233, 242, 64);
}

TEST(CssColor, rgb_with_commas_or_blanks_numbers_or_percentages) {
  expect_color("rgb(1,2,3)", 1, 2, 3);
  expect_color("rgb( 1 , 2.5 , 3 )", 1, 2.5, 3);
  expect_color("rgb(1 2 3)", 1, 2, 3);
  expect_color("rgb(100%, 50%, 0%)", 255, 127.5, 0);
  expect_color("rgba(1,2,3,.5)", 1, 2, 3, 127.5);
  expect_color("rgb(1 2 3 / 20%)", 1, 2, 3, 51);
  expect_color("rgb(300,-5,0)", 255, 0, 0);
}

TEST(CssColor, hsl_and_hwb_in_every_unit_of_angle) {
  expect_color("hsl(120, 100%, 25%)", 0, 127.5, 0);
  expect_color("hsl(120deg 100% 25% / .4)", 0, 127.5, 0, 102);
  expect_color("hsl(-240, 100%, 25%)", 0, 127.5, 0);
  expect_color("hsl(0.5turn 100% 50%)", 0, 255, 255);
  expect_color("hsl(200grad 100% 50%)", 0, 255, 255);
  expect_color("hsla(3.14159265rad, 100%, 50%, 1)", 0, 255, 255);
  expect_color("hsl(0 0% 40%)", 102, 102, 102);
  expect_color("hwb(120 20% 0%)", 51, 255, 51);
  expect_color("hwb(0 60% 60%)", 127.5, 127.5, 127.5);
}

TEST(CssColor, what_is_no_color_is_refused) {
  for (const char* text : {"",
                           " ",
                           "#",
                           "#12",
                           "#12345",
                           "#1234567",
                           "#gggggg",
                           "rgb",
                           "rgb()",
                           "rgb(1,2)",
                           "rgb(1,2,3,4,5)",
                           "rgb(1,2,x)",
                           "rgb(1,2,)",
                           "hsl(120)",
                           "hsl(a,b,c)",
                           "var(--x)",
                           "url(#a)",
                           "none",
                           "inherit",
                           "nan",
                           "rgb(nan,0,0)",
                           "rgb(1e999,0,0)",
                           "#ffffff ",
                           "blacK!"}) {
    const bool is_blank_hex = std::string_view(text) == "#ffffff ";
    EXPECT_EQ(css::parse_color(text).ok(), is_blank_hex) << text;
  }
}

TEST(CssColor, escapes_comments_and_case_are_those_of_css) {
  expect_color("r\\65 d", 255, 0, 0);
  expect_color("\\72 \\65 \\64 ", 255, 0, 0);
  expect_color("red/* c */", 255, 0, 0);
  expect_color("/**/ RED /* ; } */", 255, 0, 0);
  expect_color("RGB(/* r */255,0,/**/0)", 255, 0, 0);
  expect_color("rg\\62(255 0 0)", 255, 0, 0);
  expect_color("#F\\30 0", 255, 0, 0);
  expect_color("HSL(120DEG 100% 25%)", 0, 127.5, 0);
  expect_color("\f\r\nred\t", 255, 0, 0);
  expect_color("rgb(1e1 +2 .5e1)", 10, 2, 5);
  expect_color("rgb(1+2+3)", 1, 2, 3);
  expect_color("rgb(none 2 3)", 0, 2, 3);
  expect_color("hsl(none none 40% / none)", 102, 102, 102, 0);
  // The end of the text closes open brackets.
  expect_color("rgb(1,2,3", 1, 2, 3);
  expect_color("rgb(1 2 3 / 20%/*", 1, 2, 3, 51);
}

TEST(CssColor, commas_and_blanks_are_not_mixed) {
  for (const char* text : {"rgb(1 2, 3)",
                           "rgb(1, 2 3)",
                           "rgb(1 2 3, .5)",
                           "rgb(1, 2, 3 / .5)",
                           "rgb(1 2 3 .5)",
                           "rgb(1, 2, 3,)",
                           "rgb(,1,2,3)",
                           "rgb(1 2 3 /)",
                           "rgb(100%, 50, 0%)",
                           "rgb(none, 1, 2)",
                           "hsl(120, 100, 50)",
                           "hsl(120%, 100%, 50%)",
                           "hwb(120, 20%, 0%)",
                           "rgb(1deg 2 3)",
                           "rgb(1px 2 3)",
                           "rgb(1. 2 3)",
                           "rgb (1 2 3)",
                           "rgb(calc(1) 2 3)",
                           "r/**/ed",
                           "re d",
                           "red blue",
                           "red;",
                           "red!important",
                           "#f00 #f00",
                           "# f00",
                           "#/**/f00",
                           "'red'",
                           "rgb(1 2 3))",
                           "rgb[1 2 3]",
                           "rgb(from red r g b)"}) {
    EXPECT_FALSE(css::parse_color(text).ok()) << text;
  }
}

TEST(CssColor, near_names_are_suggested) {
  EXPECT_EQ(css::parse_color("orangge").status().message,
            "\"orangge\" is not a colour; use a CSS name, #rgb, #rrggbb, rgb(), hsl(), hwb(), "
            "lab(), lch(), oklab(), oklch() or color(); did you mean orange?");
  EXPECT_EQ(css::parse_color("currentColor").status().message,
            "currentColor depends on where it stands; use the colour itself");
}

}  // namespace
}  // namespace sfumato
