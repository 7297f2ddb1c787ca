// The elements that a compound selector matches, and the rule that wins.
#include <gtest/gtest.h>

#include "formats/each_text.hpp"
#include "formats/svg/svg_support.hpp"
#include "sfumato/base/limits.hpp"

namespace sfumato::test {
namespace {

/// Returns a document whose second of three stops has the class k.
std::string three_stops(const std::string& rules) {
  return svg("<style>" + rules +
             "</style><g class='plot a-b' id='o'><!-- --><g><linearGradient id='a'>"
             "<stop class='j' id='one'/>text<!-- --><stop class='k l' id='two' offset='.5' "
             "data-x='one two-three' lang='en-GB'/><stop class='m'/></linearGradient></g></g>"
             "<g sf:diffuse='true'><path d='M0 0h9v9' sf:left='url(#a)'/></g>");
}

/// Returns the red of the second stop, in percent.
int red_of_second(const std::string& rules) {
  const ReadDocument document = read(three_stops(rules));
  EXPECT_TRUE(document.warnings.empty())
      << (document.warnings.empty() ? "" : to_string(document.warnings[0]));
  const auto& fill = std::get<GradientFill>(document.document.shaders.at(0).paint);
  return static_cast<int>(fill.stops.at(1).color.r * 100 + .5f);
}

int matched(const std::string& selector) {
  return red_of_second(selector + "{stop-color:red}");
}

TEST(SvgSelectors, combinators_relate_elements_as_css_says) {
  expect_of_each({".plot stop",
                  ".plot .k",
                  "#o g stop",
                  "svg .plot  linearGradient\n> stop",
                  "linearGradient>stop",
                  "g > linearGradient > .k",
                  "g g .k",
                  "svg * stop",
                  ".j + stop",
                  ".j~.k",
                  "#one + .k",
                  "g #one ~ .k",
                  "* * * * .k",
                  ":root .k",
                  ":root > g .k",
                  "stop.k",
                  ".k.l",
                  "stop#two.k",
                  ".a-b .k",
                  "* + .k"},
                 matched, 100);
  expect_of_each({"g > stop", ".k stop", "svg > linearGradient > stop", ".m + .k", ".k + .k",
                  ".j + .j", "g * * * stop", "* * * * * .k", ":root > .k", ".k.m", "stop.j#two",
                  "path .k", ".m ~ stop.k", "linearGradient + .k", "svg + g .k"},
                 matched, 0);
}

TEST(SvgSelectors, a_search_goes_on_from_other_ancestors_and_siblings) {
  // The nearest element that fits some parts does not fit all.
  EXPECT_EQ(matched(".plot > g .k"), 100);
  EXPECT_EQ(matched("svg > g g linearGradient .k"), 100);
  EXPECT_EQ(matched("#o > g > linearGradient > .j + .k"), 100);
  EXPECT_EQ(matched("svg > g > .j ~ .k"), 0);
}

TEST(SvgSelectors, attributes_are_compared) {
  expect_of_each({"[data-x]", "stop[offset]", "[data-x~=one]", "[data-x~='two-three']",
                  "[lang|=en]", "[data-x^=one]", "[data-x$=\"three\"]", "[data-x*='e t']",
                  "[offset='.5']", "[LANG-x], [lang='EN-gb' i]", "[ lang = 'en-GB' s ]",
                  "g [class~=l]", "[\\6c ang]", "[lang='en\\2dGB']"},
                 matched, 100);
  expect_of_each({"[x]", "[data-x=one]", "[data-x~=two]", "[data-x|=one]", "[data-x^=two]",
                  "[data-x$=one]", "[data-x*='x']", "[data-x*='']", "[data-x^='']", "[data-x~='']",
                  "[lang='EN-gb']", "[Lang]", "[lang|=e]"},
                 matched, 0);
}

TEST(SvgSelectors, pseudo_classes_look_at_siblings) {
  expect_of_each(
      {".k:not(:first-child)", "stop:not(:last-child):not(.j)", ":not(g).k",
       "linearGradient:only-child > .k", ":not([x]).k", "g g:only-child .k", ".k:not(:hover)"},
      matched, 100);
  expect_of_each({".k:first-child", ".k:last-child", ".k:only-child", ".k:root", ".k:hover",
                  ".k:not(.l)", "#o:only-child .k", ".j:first-child:focus ~ .k"},
                 matched, 0);
}

TEST(SvgSelectors, the_more_specific_rule_wins) {
  const auto red_wins = [](const std::string& rules) { return red_of_second(rules); };
  expect_of_each(
      {"g stop{stop-color:red} stop{stop-color:blue}",
       ".k{stop-color:red} g g stop{stop-color:blue}", "g .k{stop-color:red} .k{stop-color:blue}",
       "#two{stop-color:red} .plot g .k.l{stop-color:blue}",
       "#o stop{stop-color:red} .plot .k.l{stop-color:blue}",
       "g .k{stop-color:blue} g .k{stop-color:red}", ".k{stop-color:blue} [lang]{stop-color:red}",
       ":not(#x).k{stop-color:red} .k.l[lang]{stop-color:blue}",
       "g stop{stop-color:red !important} #two{stop-color:blue}",
       "stop{stop-color:red !important} #o .k{stop-color:blue}",
       ".plot .j, .plot .k{stop-color:red}", ".k, .plot .x{stop-color:red}"},
      red_wins, 100);
}

TEST(SvgSelectors, what_is_not_read_drops_its_selector_alone) {
  const auto warnings =
      warnings_of(three_stops(".plot stop:nth-child(2), .plot .k{stop-color:red}"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "a.svg:2:1: the style rule \".plot stop:nth-child(2)\" is not read; use "
            "selectors of names, classes, ids and attributes");
  std::string deep = "g";
  for (int i = 0; i < 64; ++i) deep += " g";
  EXPECT_EQ(warnings_of(three_stops(deep + "{stop-color:red}")).size(), 1u);
}

TEST(SvgSelectors, steps_have_a_limit_that_costs_the_rest_of_the_styles) {
  Context context;
  context.limits.selector_steps = 5;
  const Result<ReadDocument> document =
      read_svg(context, three_stops(".plot .k{stop-color:red}"), "a.svg");
  ASSERT_TRUE(document) << to_string(document.status());
  ASSERT_EQ(document->warnings.size(), 1u);
  EXPECT_NE(document->warnings[0].message.find("more than the limit of 5 steps of selectors"),
            std::string::npos)
      << document->warnings[0].message;
}

TEST(SvgSelectors, hostile_selectors_end_within_the_limit) {
  std::string groups, ends, parts;
  for (int i = 0; i < 200; ++i) groups += "<g class='a'>", ends += "</g>";
  for (int i = 0; i < 60; ++i) parts += i % 2 == 0 ? ".a " : ".a > ";
  const Status status = status_of(svg("<style>" + parts + "b{fill:red} .z " + parts +
                                      "g{fill:red}</style>" + groups + kStroke + ends));
  EXPECT_TRUE(status.ok()) << to_string(status);
}

}  // namespace
}  // namespace sfumato::test
