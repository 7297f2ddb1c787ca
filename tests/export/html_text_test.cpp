#include "export/html/html_text.hpp"

#include <gtest/gtest.h>

namespace sfumato::outputs {
namespace {

TEST(HtmlText, markup_is_escaped) {
  EXPECT_EQ(escaped_html("a<b>&\"c\"\n\x01"), "a&lt;b&gt;&amp;&quot;c&quot;  ");
}

}  // namespace
}  // namespace sfumato::outputs
