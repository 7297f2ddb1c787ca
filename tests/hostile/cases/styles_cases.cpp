// Style sheets and style attributes.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string sheet(const std::string& rules) {
  return svg("<style>" + rules + "</style>" + kLayer);
}

std::string styled(const std::string& style) {
  return svg("<g style='" + style + "'>" + kLayer + "</g>");
}

void add_sheets(Family& family) {
  family.add("rules_2000_for_200_parts", kLimit, "more than the limit of 100000 values",
             [] { return sheet(repeated(numbered("a", 200, ",") + "b{opacity:1}", 2000)); });
  family.add("selectors_times_values", kLimit, "more than the limit of 100000 values", [] {
    return sheet("a" + repeated(",a", 10'000) + "{" + repeated("b:c;", 10'000) + "}");
  });
  family.add("selectors_times_nothing", kDone, "", [] {
    return sheet("a" + repeated(",a", 200'000) + "{" + repeated(";", 200'000) + "}");
  });
  family.add("selectors_times_blanks", kDone, "", [] {
    return sheet("a" + repeated(",a", 200'000) + "{" + repeated(" ", 200'000) + "}");
  });
  family.add("selectors_times_comments", kDone, "", [] {
    return sheet("a" + repeated(",a", 100'000) + "{" + repeated("/**/", 100'000) + "}");
  });
  family.add("selectors_times_a_long_value", kDone, "", [] {
    return sheet("a" + repeated(",a", 90'000) + "{b:" + repeated("c", 200'000) + "}");
  });
  family.add("selector_of_a_megabyte_times_values", kDone, "", [] {
    return sheet("." + repeated("a", kMillion) + "{" + numbered("b", 90'000, ":c;") + "}");
  });
  family.add("property_of_a_megabyte_times_selectors", kDone, "", [] {
    return sheet(numbered(".a", 90'000, ",") + "b{" + repeated("b", kMillion) + ":c}");
  });
  family.add("values_up_to_the_limit", kDone, "",
             [] { return sheet(numbered(".a", 99'000, "{fill:red}")); });
  family.add("values_100000_for_100000_elements", kDone, "", [] {
    return svg("<style>" + numbered(".a", 50'000, "{fill:red}") + "</style>" +
               numbered("<g class='a", 100'000, "'/>") + kLayer);
  });
  family.add("classes_100000_on_one_element", kDone, "", [] {
    return svg("<style>" + numbered(".a", 50'000, "{fill:red}") + "</style><g class='" +
               numbered("a", 100'000, " ") + "'/>" + kLayer);
  });
  family.add("sheets_200000", kDone, "",
             [] { return svg(repeated("<style>a{b:c}</style>", 90'000) + kLayer); });
  family.add("sheet_of_many_texts", kDone, "",
             [] { return sheet(repeated("a{b:c}<!---->", 90'000)); });
  family.add("imports_a_million", kDone, "is not read",
             [] { return sheet(repeated("@import url(a);", kMillion)); });
  family.add("blocks_without_end", kDone, "", [] { return sheet(repeated("a{", kMillion)); });
  family.add("blocks_without_begin", kDone, "is not read",
             [] { return sheet(repeated("}", kMillion)); });
  family.add("nested_at_rules", kDone, "",
             [] { return sheet(repeated("@media a{", 500'000) + repeated("}", 500'000)); });
  family.add("comments_a_million", kDone, "", [] { return sheet(repeated("/*a*/", kMillion)); });
  family.add("comment_without_end", kDone, "",
             [] { return sheet("/*" + repeated("a", kMillion)); });
  family.add("comment_openings_a_million", kDone, "is not read",
             [] { return sheet(repeated("/*", kMillion)); });
  family.add("media_a_million", kDone, "",
             [] { return sheet(repeated("@media screen{", 500'000)); });
  family.add("media_queries_a_million", kDone, "is not read",
             [] { return sheet("@media " + repeated("(a),", kMillion) + "b{}"); });
  family.add("escapes_a_million", kDone, "is not read",
             [] { return sheet("." + repeated("\\61 ", kMillion) + "{fill:red}"); });
  family.add("classes_of_escapes", kDone, "",
             [] { return sheet(numbered(".\\61", 99'000, "{fill:red}")); });
  family.add("blocks_in_values", kDone, "",
             [] { return sheet("a{" + repeated("b:c{}", kMillion)); });
  family.add("blocks_as_values", kDone, "",
             [] { return sheet("a{" + repeated("b:{}(", kMillion)); });
  family.add("blocks_in_custom_properties", kDone, "",
             [] { return sheet("a{" + repeated("--b:{}", kMillion) + ")}"); });
  family.add("addresses_before_a_paint", kDone, "",
             [] { return sheet("a{fill:" + repeated("url(#b) ", kMillion) + "red}"); });
  family.add("brackets_in_each_other", kDone, "",
             [] { return sheet("a{b:" + repeated("([{", kMillion)); });
  family.add("strings_that_break", kDone, "",
             [] { return sheet("a{" + repeated("b:\"c\n", kMillion)); });
  family.add("urls_that_break", kDone, "",
             [] { return sheet("a{" + repeated("b:url(c d", kMillion)); });
  family.add("html_comments", kDone, "",
             [] { return sheet("<![CDATA[" + repeated("<!-- -->", kMillion) + "]]>"); });
  family.add("quotes_without_end", kDone, "", [] { return sheet(repeated("a{b:\"c}", 100'000)); });
  family.add("parentheses_without_end", kDone, "",
             [] { return sheet(repeated("a{b:(c;}", 100'000)); });
  family.add("selectors_of_commas", kDone, "is not read",
             [] { return sheet(repeated(",", kMillion) + "{a:b}"); });
  family.add("selectors_not_simple", kDone, "is not read; use selectors",
             sheet("a > b ~ c:nth-child(2n+1)::before [d] * {fill:red}"));
  family.add("bytes", kDone, "", sheet("\x80\xff{a:b}"));
  family.add("selectors_times_elements", kDone, "more than the limit of", [] {
    return svg("<style>" + numbered("g ~ g[a*='", 9'000, "']{fill:red}") + "</style>" +
               repeated("<g a='b'/>", 100'000) + kLayer);
  });
  family.add("descendants_of_descendants", kDone, "", [] {
    return svg("<style>" + repeated("g ", 63) + "b{fill:red} " + repeated("g ", 60) +
               " z g{fill:red}</style>" + repeated("<g>", 240) + repeated("<g/>", 10'000) +
               repeated("</g>", 240) + kLayer);
  });
  family.add("selectors_of_a_thousand_parts", kDone, "is not read",
             [] { return sheet(repeated("a ", 1000) + "{fill:red}"); });
  family.add("attribute_searched_for_a_long_text", kDone, "more than the limit of", [] {
    return svg("<style>g[a*='" + repeated("a", 300'000) + "b']{fill:red}</style><g a='" +
               repeated("a", kMillion) + "'/>" + kLayer);
  });
  family.add("settings_of_every_element", kDone, "", [] {
    return svg("<style>svg g{" + repeated("all:unset;", 100) + "}</style>" +
               repeated("<g/>", 60'000) + kLayer);
  });
}

void add_attributes(Family& family) {
  family.add("style_of_a_million_values", kDone, "",
             [] { return styled(repeated("a:b;", kMillion)); });
  family.add("style_of_colons", kDone, "", [] { return styled(repeated(":", kMillion)); });
  family.add("style_of_quotes", kDone, "", [] { return styled(repeated("\"", kMillion)); });
  family.add("style_of_parentheses", kDone, "", [] { return styled(repeated("(", kMillion)); });
  family.add("style_of_braces", kDone, "", [] { return styled(repeated("{};", kMillion)); });
  family.add("style_on_every_element", kDone, "", [] {
    return svg(repeated("<g style='" + repeated("a:b;", 100) + "'/>", 10'000) + kLayer);
  });
  family
      .add("style_at_every_depth", kDone, "has no attribute of Sfumato",
           [] {
             return svg(repeated("<g style='" + repeated("a:b;", 2000) + "'>", 200) +
                        "<rect width='100%' height='100%'/>" + repeated("</g>", 200) + kLayer);
           })
      .message = "";
  family.add("opacity_nan", kDone, "is left out", styled("opacity:nan"));
  family.add("opacity_huge", kDone, "", styled("opacity:1e300"));
  family.add("opacity_negative", kDone, "", styled("opacity:-1e300%"));
  family.add("opacity_empty", kDone, "is left out", styled("opacity:"));
  family.add("important_twice", kDone, "", styled("opacity:1 !important !important"));
  family.add("blend_unknown", kDone, "is left out", styled("mix-blend-mode:ad"));
  family.add("blend_of_100000_names", kDone, "more of other kinds", [] {
    std::string groups;
    for (int i = 0; i < 100'000; ++i) {
      groups += "<g mix-blend-mode='a" + std::to_string(i) + "'/>";
    }
    return svg(groups + kLayer);
  });
  family.add("inherit_at_every_depth", kDone, "", [] {
    return svg(repeated("<g opacity='inherit'>", 250) +
               repeated("<g><g style='opacity:inherit;fill:inherit'/></g>", 100'000) +
               repeated("</g>", 250) + kLayer);
  });
  family.add("style_of_importance", kDone, "",
             [] { return styled(repeated("opacity:1!important;all:unset;", kMillion / 4)); });
  family.add("colour_of_15_mb", kBadInput, "is not a colour",
             [] { return curve("sf:left='rgb(1,2," + repeated("1", 15 * kMillion) + ")'"); });
  family.add("transform_in_a_style", kBadInput, "too large or too small",
             styled("transform:scale(1e300)"));
  family.add("transforms_in_a_style", kDone, "",
             [] { return styled("transform:" + repeated("rotate(1deg)", kMillion)); });
  family.add("variable_of_a_megabyte", kDone, "exceed a limit",
             [] { return styled("--a:" + repeated("b", kMillion) + ";opacity:var(--a)"); });
  family.add("variables_that_double", kDone, "exceed a limit", [] {
    std::string style = "--a0:1;opacity:var(--a30)";
    for (int i = 1; i <= 30; ++i) {
      const std::string inner = "var(--a" + std::to_string(i - 1) + ")";
      style += ";--a" + std::to_string(i) + ":" + inner + inner;
    }
    return styled(style);
  });
  family.add("fallbacks_in_each_other", kDone, "exceed a limit",
             [] { return styled("opacity:" + repeated("var(--a,", 100'000)); });
  family.add("variables_a_million", kDone, "is left out",
             [] { return styled(numbered("--a", kMillion, ":b;") + "opacity:var(--a1)"); });
  family.add("variables_of_every_element", kDone, "", [] {
    return svg("<style>:root{--a:" + repeated(" ", 60'000) + "red}</style>" +
               repeated("<g style='opacity:var(--a)'/>", 20'000) + kLayer);
  });
  family.add("font_sizes_that_grow", kDone, "", [] {
    return svg(repeated("<g font-size='1000em'>", 200) + kLayer + repeated("</g>", 200));
  });
  family.add("boxes_in_each_other", kDone, "", [] {
    return svg(repeated("<g style='transform-box:fill-box;transform:scale(1)'>", 200) + kLayer +
               repeated("</g>", 200));
  });
}

void add_styles_cases(Family& family) {
  add_sheets(family);
  add_attributes(family);
}

const Register kStyles("styles", add_styles_cases);

}  // namespace
}  // namespace sfumato::hostile
