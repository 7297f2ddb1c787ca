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

TEST(HtmlText, a_module_loses_its_imports_however_they_are_laid_out) {
  for (const char* import :
       {"import { a } from \"./a.js\";\n", "import {\na,\nb,\n} from './a.js';\n",
        "import\n{ a }\nfrom \"./a.js\"\n;\n", "import{a}from\"./a.js\";\n", "import \"./a.js\";\n",
        "import\"./a.js\";\n", "import * as a from \"./a.js\"; \n", "import a from \"./a.js\";\r\n",
        "import { a } from \"./a.js\"; import { b } from \"./b.js\";\n",
        "export { a } from \"./a.js\";\n", "export * from \"./a.js\";\n", "export {\na,\n};\n"}) {
    const std::string module = std::string(import) + "f();\n" + import + "g();\n";
    EXPECT_EQ(script_of_module(module), "f();\ng();\n") << import;
  }
  EXPECT_EQ(script_of_module("import { a } from \"./a.js\"; f();\n"), "f();\n");
  EXPECT_EQ(script_of_module("import { a } from \"./a.js\""), "");
}

TEST(HtmlText, what_a_module_exports_is_declared) {
  EXPECT_EQ(script_of_module("export const A = 1;\nexport function f() {\n}\nexport class B {}\n"
                             "export async function g() {\n}"),
            "const A = 1;\nfunction f() {\n}\nclass B {}\nasync function g() {\n}");
}

TEST(HtmlText, what_only_looks_like_a_module_stays) {
  const std::string text =
      "important = 1;\nimport(\"./a.js\");\nimport (\"./a.js\");\nimport.meta.url;\nexported();\n"
      "export_ = 2;\nf(\"import { a };\");\n\"export \";\n{ import: 3 }\nimport: 4\nexport: 5\n";
  EXPECT_EQ(script_of_module(text), text);
  EXPECT_EQ(script_of_module(""), "");
}

TEST(HtmlText, blanks_that_a_script_can_do_without_are_left_out) {
  EXPECT_EQ(squeezed("const a = [1, 2];\nif (a in b) return -1;\nf(a + +b, a - -b, a + -b);\n"),
            "const a=[1,2];\nif(a in b)return-1;\nf(a+ +b,a- -b,a+-b);\n");
  EXPECT_EQ(squeezed("f(\"a  b\", 'c \" d', \"e \\\" f\", g);"),
            "f(\"a  b\",'c \" d',\"e \\\" f\",g);");
  for (const char* as_it_is : {"const a = / \" /;", "f(`a  ${b}`, c);", "a = b / c;", "\n", ""})
    EXPECT_EQ(squeezed(as_it_is), as_it_is);
}

TEST(HtmlText, nothing_stays_nothing) {
  EXPECT_EQ(condensed(""), "");
  EXPECT_EQ(condensed("/* open"), "");
}

}  // namespace
}  // namespace sfumato::outputs
