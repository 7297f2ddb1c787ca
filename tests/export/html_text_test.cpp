#include "export/html/html_text.hpp"

#include <gtest/gtest.h>

namespace sfumato::outputs {
namespace {

TEST(HtmlText, markup_is_escaped) {
  EXPECT_EQ(escaped_html("a<b>&\"c\"\n\x01"), "a&lt;b&gt;&amp;&quot;c&quot;  ");
}

TEST(HtmlText, comments_that_begin_a_line_are_left_out) {
  EXPECT_EQ(condensed("// one\nf();  // two\n  /** three */\n/* four\n * five\n */\n"),
            "f();  // two\n");
}

TEST(HtmlText, what_follows_a_comment_stays) {
  EXPECT_EQ(condensed("  /** @type {X} */ (x).f();\n/* a\n b */ /* c */ g();"), "(x).f();\ng();\n");
}

TEST(HtmlText, lines_stay_lines_without_their_indentation) {
  EXPECT_EQ(condensed("#ifdef A\n  b(\n    \"  c // d\"\n\n  )\n#endif"),
            "#ifdef A\nb(\n\"  c // d\"\n)\n#endif\n");
}

TEST(HtmlText, nothing_stays_nothing) {
  EXPECT_EQ(condensed(""), "");
  EXPECT_EQ(condensed("/* open"), "");
}

}  // namespace
}  // namespace sfumato::outputs
