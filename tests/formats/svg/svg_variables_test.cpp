// Custom properties and var().
#include <gtest/gtest.h>

#include "formats/each_text.hpp"
#include "formats/svg/svg_support.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::test {
namespace {

std::string shown(const Rgb& color) {
  std::string text = "#";
  for (const float channel : {color.r, color.g, color.b}) {
    text += "0123456789abcdef"[static_cast<int>(channel * 15 + .5f)];
  }
  return text;
}

/// Returns a gradient of one stop within a group.
std::string one_stop(const std::string& stop, const std::string& group, const std::string& rules) {
  return svg("<style>" + rules + "</style><g " + group + "><linearGradient id='a'><stop id='s' " +
             stop +
             "/></linearGradient></g><g sf:diffuse='true'><path d='M0 0h9v9' "
             "sf:left='url(#a)'/></g>");
}

/// Returns the stop's colour, "#f00", with a count of warnings if there are any.
std::string stop_color(const std::string& stop, const std::string& group = "",
                       const std::string& rules = "") {
  const ReadDocument document = read(one_stop(stop, group, rules));
  const auto& fill = std::get<GradientFill>(document.document.shaders.at(0).paint);
  const std::size_t warnings = document.warnings.size();
  return shown(fill.stops.at(0).color) + (warnings ? " " + std::to_string(warnings) : "");
}

TEST(SvgVariables, values_come_from_the_element_and_those_around_it) {
  const std::string use = "style='stop-color:var(--c)'";
  EXPECT_EQ(stop_color("style='--c:red;stop-color:var(--c)'"), "#f00");
  EXPECT_EQ(stop_color("style='stop-color:var(--c);--c:red'"), "#f00");
  EXPECT_EQ(stop_color(use, "style='--c:red'"), "#f00");
  EXPECT_EQ(stop_color(use, "", ":root{--c:red}"), "#f00");
  EXPECT_EQ(stop_color(use, "style='--c:red'", ":root{--c:blue}"), "#f00");
  EXPECT_EQ(stop_color(use, "class='x'", ".x{--c:lime} .x #s{--c:red}"), "#f00");
  EXPECT_EQ(stop_color(use, "style='--c:blue'", "#s{--c:red !important}"), "#f00");
  EXPECT_EQ(stop_color("stop-color='var(--c)'", "style='--c:red'"), "#f00");
  EXPECT_EQ(stop_color("", "style='--c:red'", "svg stop{stop-color:var(--c)}"), "#f00");
  EXPECT_EQ(stop_color("style='stop-color:var(--C)'", "style='--c:red;--C:blue'"), "#00f")
      << "names have a case";
}

TEST(SvgVariables, a_fallback_counts_where_there_is_no_value) {
  expect_of_each(
      {"stop-color='var(--x, red)'", "style='stop-color:var(--x,red)'",
       "style='stop-color: VAR( --x , red )'", "style='stop-color:var(--x, var(--y, red))'",
       "style='--y:red;stop-color:var(--x, var(--y, blue))'",
       "style='--x:initial;stop-color:var(--x, red)'",
       "style='stop-color:var(--x, rgb(255, var(--y, 0), 0))'",
       "style='--g:0;stop-color:rgb(255 var(--g) var(--g))'", "style='--e:;stop-color:var(--e)red'",
       "style='stop-color:var(--x,)red'", "style='stop-color:red;stop-color:var(--x, #f00'"},
      [](const std::string& stop) { return stop_color(stop); }, "#f00");
}

TEST(SvgVariables, a_value_that_is_none_makes_the_property_inherited_or_initial) {
  // stop-color is not inherited, so it is black. Nothing below the declaration in the cascade
  // counts.
  expect_of_each(
      {"stop-color='red' style='stop-color:var(--x)'", "style='stop-color:red;stop-color:var(--x)'",
       "stop-color='var(--x)'", "style='--x:10px;stop-color:var(--x)'",
       "style='--x:red blue;stop-color:var(--x)'", "style='--r:re;stop-color:var(--r)d'",
       "stop-color='var(x)'", "style='stop-color:var(--x, initial)'"},
      [](const std::string& stop) { return stop_color(stop); }, "#000");
  EXPECT_EQ(stop_color("style='stop-color:currentColor;color:var(--x)'", "color='red'"), "#f00")
      << "color is inherited";
  EXPECT_EQ(stop_color("style='stop-color:var(--x,inherit)'", "style='stop-color:red'"), "#000")
      << "from the gradient between";
  EXPECT_EQ(stop_color("stop-color='red' style='stop-color:var(x)'"), "#f00 1")
      << "invalid where it stands";
}

TEST(SvgVariables, cycles_have_no_value) {
  const std::string rules = "stop{stop-color:var(--a, red)}";
  expect_of_each(
      {"--a:var(--a)", "--a:var(--a, lime)", "--a:var(--b);--b:var(--a)",
       "--a:var(--b, lime);--b:var(--c);--c:var(--b, lime);--c:var(--a, lime)",
       "--a:var(--b);--b:var(--c);--c:var(--a)"},
      [&](const std::string& style) { return stop_color("style='" + style + "'", "", rules); },
      "#f00");
  EXPECT_EQ(stop_color("style='--a:var(--b,lime);--b:var(--b)'", "", rules), "#0f0")
      << "the cycle is beside it";
  EXPECT_EQ(stop_color("style='--a:var(--b)'", "style='--b:var(--a);--a:lime'", rules), "#0f0")
      << "another element's property of that name";
}

TEST(SvgVariables, names_that_are_not_read_are_told) {
  EXPECT_EQ(stop_color("style='--" + std::string(300, 'x') + ":red'"), "#000 1");
  EXPECT_EQ(stop_color("style='--\\61:red'"), "#000 1");
}

std::string warning_of(const std::string& style, const Limits& limits = {}) {
  Context context{.limits = limits};
  const Result<ReadDocument> document =
      read_svg(context, one_stop("style='" + style + "'", "", ""), "a.svg");
  EXPECT_TRUE(document) << to_string(document.status());
  EXPECT_EQ(context.budget.used(), 0u);
  return document && !document->warnings.empty() ? document->warnings[0].message : "";
}

TEST(SvgVariables, expansion_has_limits) {
  std::string chain = "--v0:red;stop-color:var(--v40)", laughs = "--v0:;stop-color:var(--v30)";
  for (int i = 1; i <= 40; ++i) {
    const std::string name = "--v" + std::to_string(i) + ":",
                      inner = "var(--v" + std::to_string(i - 1) + ")";
    chain = name + inner + ";" + chain;
    laughs = name + inner + inner + ";" + laughs;
  }
  for (const std::string& style :
       {chain, laughs, "--v:" + std::string(70'000, 'x') + ";stop-color:var(--v)"}) {
    EXPECT_NE(warning_of(style).find("var() exceed a limit"), std::string::npos)
        << style.substr(0, 40);
  }
  Limits few;
  few.variable_bytes = 50;
  EXPECT_NE(warning_of("--v:red;stop-color:var(--v)", few).find("limit variable-depth"),
            std::string::npos);
  EXPECT_EQ(warning_of("--v:red;stop-color:var(--v)"), "");
}

}  // namespace
}  // namespace sfumato::test
