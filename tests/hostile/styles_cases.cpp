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
  family.add("nested_at_rules", kDone, "is not read",
             [] { return sheet(repeated("@media a{", 500'000) + repeated("}", 500'000)); });
  family.add("comments_a_million", kDone, "", [] { return sheet(repeated("/*a*/", kMillion)); });
  family.add("comment_without_end", kDone, "",
             [] { return sheet("/*" + repeated("a", kMillion)); });
  family.add("comment_openings_a_million", kDone, "is not read",
             [] { return sheet(repeated("/*", kMillion)); });
  family.add("html_comments", kDone, "",
             [] { return sheet("<![CDATA[" + repeated("<!-- -->", kMillion) + "]]>"); });
  family.add("quotes_without_end", kDone, "", [] { return sheet(repeated("a{b:\"c}", 100'000)); });
  family.add("parentheses_without_end", kDone, "",
             [] { return sheet(repeated("a{b:(c;}", 100'000)); });
  family.add("selectors_of_commas", kDone, "",
             [] { return sheet(repeated(",", kMillion) + "{a:b}"); });
  family.add("selectors_not_simple", kDone, "is not read; expected simple selectors",
             sheet("a > b ~ c:nth-child(2n+1)::before [d] * {fill:red}"));
  family.add("bytes", kDone, "", sheet("\x80\xff{a:b}"));
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
  family.add("opacity_nan", kBadInput, "opacity of <g>", styled("opacity:nan"));
  family.add("opacity_huge", kDone, "", styled("opacity:1e300"));
  family.add("opacity_negative", kDone, "", styled("opacity:-1e300%"));
  family.add("opacity_empty", kBadInput, "opacity of <g>", styled("opacity:"));
  family.add("important_twice", kBadInput, "opacity of <g>",
             styled("opacity:1 !important !important"));
  family.add("blend_unknown", kDone, "is not known; normal is used", styled("mix-blend-mode:ad"));
  family.add("blend_of_100000_names", kDone, "more of other kinds", [] {
    std::string groups;
    for (int i = 0; i < 100'000; ++i) {
      groups += "<g style='mix-blend-mode:a" + std::to_string(i) + "'/>";
    }
    return svg(groups + kLayer);
  });
  family.add("transform_in_a_style", kDone, "a transform in style is not read",
             styled("transform:scale(1e300)"));
}

void add_cases(Family& family) {
  add_sheets(family);
  add_attributes(family);
}

const Register kStyles("styles", add_cases);

}  // namespace
}  // namespace sfumato::hostile
