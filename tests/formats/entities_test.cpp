#include "formats/text/entities.hpp"

#include <gtest/gtest.h>

#include <string>

#include "formats/each_text.hpp"
#include "formats/text/xml_source.hpp"

namespace sfumato {
namespace {

std::string typed(const std::string& declarations, const std::string& content) {
  return "<!DOCTYPE svg [" + declarations + "]>" + content;
}

/// Returns the expanded text after the DTD, or the error.
std::string expanded(const std::string& declarations, const std::string& content,
                     const Limits& limits = {}) {
  Context context{.limits = limits};
  const std::string text = typed(declarations, content);
  text::ExpandedText result;
  const Status status = result.expand(context, text);
  if (!status) return status.message;
  return std::string(result.text().substr(typed(declarations, "").size()));
}

TEST(Entities, are_replaced_in_content_and_attributes) {
  const std::string a = "<!ENTITY a 'red'>";
  EXPECT_EQ(expanded(a, "<g fill='&a;'>&a;</g>"), "<g fill='red'>red</g>");
  EXPECT_EQ(expanded(a, "<g fill=\"&a;\"/>&a;"), "<g fill=\"red\"/>red");
  EXPECT_EQ(expanded(a, "&b;&amp;&#65;&a&;<g a=&a;/>"), "&b;&amp;&#65;&a&;<g a=&a;/>");
  EXPECT_EQ(expanded(a + "<!ENTITY a 'blue'>", "&a;"), "red");  // the first declaration counts
}

TEST(Entities, may_be_elements_and_hold_others) {
  const std::string entities =
      "<!-- <!ENTITY a 'no'> --><?x <!ENTITY a 'no'> ?><!ELEMENT g ANY>"
      "<!ENTITY b \"it's &a;\"><!ENTITY a '<g id=\"1\"/>'>";
  EXPECT_EQ(expanded(entities, "<s>&b;</s>"), "<s>it's <g id=\"1\"/></s>");
  EXPECT_EQ(expanded(entities, "<s a='&b;'/>"), "<s a='it&#39;s &lt;g id=&quot;1&quot;/>'/>");
}

TEST(Entities, characters_are_decoded_where_they_are_declared) {
  EXPECT_EQ(expanded("<!ENTITY a '&#60;g/&#x3E;'>", "&a;"), "<g/>");
  EXPECT_EQ(expanded("<!ENTITY a '&#38;lt;'>", "&a;"), "&lt;");
  EXPECT_EQ(expanded("<!ENTITY a '&#38;b;'><!ENTITY b 'c'>", "&a;"), "c");
  EXPECT_EQ(expanded("<!ENTITY a '&#233;&#x;'>", "&a;"), "&#233;&#x;");
}

TEST(Entities, stay_in_comments_sections_and_instructions) {
  for (const std::string verbatim : {"<!--&a;-->", "<![CDATA[&a;]]>", "<?x &a;?>"}) {
    EXPECT_EQ(expanded("<!ENTITY a 'b'>", verbatim + "&a;"), verbatim + "b");
  }
}

TEST(Entities, that_are_external_or_parameters_stay) {
  for (const std::string declaration :
       {"<!ENTITY a SYSTEM '/etc/passwd'>", "<!ENTITY a PUBLIC 'b' \"c>\">",
        "<!ENTITY a SYSTEM 'b' NDATA c>", "<!ENTITY % a 'b'>%a;"}) {
    Context context;
    const std::string text = typed(declaration + "<!ENTITY c 'd'>", "&a;&c;");
    text::ExpandedText result;
    ASSERT_TRUE(result.expand(context, text));
    EXPECT_TRUE(result.text().ends_with(">&a;d")) << result.text();
    ASSERT_EQ(result.notes().size(), 1u) << declaration;
    EXPECT_NE(result.notes()[0].message.find("not read"), std::string::npos);
  }
}

TEST(Entities, that_end_within_a_tag_are_errors) {
  for (const char* text : {"<g", "<g a='", "<!-- ", "<![CDATA["}) {
    const std::string entity = "<!ENTITY a \"" + std::string(text) + "\">";
    EXPECT_NE(expanded(entity, "&a;").find("ends within a tag"), std::string::npos) << text;
  }
}

TEST(Entities, keep_within_their_limits) {
  const Limits few{.entity_bytes = 10, .entity_depth = 2};
  EXPECT_EQ(expanded("<!ENTITY a '123456789'>", "&a;", few), "123456789");
  EXPECT_EQ(expanded("<!ENTITY a '1234567890'>", "&a;", few),
            "more than the limit of 10 bytes of entities");
  EXPECT_EQ(expanded("<!ENTITY a ''>", "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;", few), "");
  EXPECT_EQ(expanded("<!ENTITY a ''>", "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;", few),
            "more than the limit of 10 bytes of entities");
  EXPECT_EQ(expanded("<!ENTITY a '&b;'><!ENTITY b 'c'>", "&a;", few), "c");
  for (const char* loop : {"<!ENTITY a '&a;'>", "<!ENTITY a '&b;'><!ENTITY b '&a;'>"}) {
    for (const char* place : {"&a;", "<g a='&a;'/>"}) {
      EXPECT_EQ(expanded(loop, place, few), "more than the limit of 2 entities within each other");
    }
  }
}

TEST(Entities, of_unfinished_texts_are_no_trouble) {
  const std::string whole =
      "\xEF\xBB\xBF<?xml version='1.0'?><!-- a --><!DOCTYPE svg PUBLIC \"a\" 'b' [ <!ENTITY % p "
      "'x'> %p; <!ENTITY a '&#60;b&#62;'><!ATTLIST g a CDATA 'b'> ] ><svg a='&a;'>&a;<!--&a;-->"
      "<![CDATA[&a;]]><?a &a;?>&b;&#65;</svg>";
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    Context context;
    const std::string text = whole.substr(0, size);
    {
      text::ExpandedText result;
      EXPECT_TRUE(result.expand(context, text)) << text;
      for (std::size_t i = 0; i <= result.text().size(); ++i) {
        EXPECT_LE(result.origin(i), text.size());
        EXPECT_LE(result.origin(i - (i > 0 ? 1 : 0)), result.origin(i));
      }
    }
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

/// Returns "line:column <element>" of an element with an id, or the error.
std::string place_of(const std::string& text) {
  Context context;
  const std::string file = "a.svg";
  text::XmlSource source(text, file);
  const Status status = source.parse(context);
  if (!status) return to_string(status);
  const pugi::xml_node found = source.root().find_node(
      [](pugi::xml_node node) { return std::string(node.attribute("id").value()) == "x"; });
  const SourcePlace place = source.place(found);
  return std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
         text.substr(source.offset(found), 3);
}

TEST(Entities, keep_the_places_of_the_file) {
  const std::string head = "<!DOCTYPE svg [\n<!ENTITY a 'long\nlong\nlong'>\n]>\n<svg>\n";
  EXPECT_EQ(place_of(head + "<g id='x'/></svg>"), "7:1 <g ");
  EXPECT_EQ(place_of(head + "&a;<g id='x'/></svg>"), "7:4 <g ");
  EXPECT_EQ(place_of(head + "<b c='&a;&a;'>&a;</b>\n <g id='x' a='&a;'/></svg>"), "8:2 <g ");
  EXPECT_EQ(place_of("<!DOCTYPE svg [<!ENTITY a \"<g/><g id='x'/>\">]>\n<svg>\n &a;</svg>"),
            "3:2 &a;");
  EXPECT_EQ(place_of(head + "&a;\n</b></svg>").substr(0, 10), "a.svg:8:3:");
  EXPECT_EQ(place_of(typed("<!ENTITY a '&a;'>", "\n<svg>\n &a;</svg>")),
            "a.svg:3:2: more than the limit of 16 entities within each other");
}

}  // namespace
}  // namespace sfumato
