// Text that is hardly XML, or XML of absurd proportions.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

void add_broken_xml(Family& family) {
  const std::string good = svg(kLayer);
  family.add("empty", kBadInput, "in.svg: error: the file is empty", "");
  family.add("blanks", kBadInput, "in.svg: error: no XML element found", " \t\r\n");
  family.add("text", kBadInput, "in.svg: error: no XML element found", "P3 2 2 255\n0 0 0\n");
  family.add("one_bracket", kBadInput, "in.svg:1:1: error: the XML is cut short", "<");
  family.add("only_brackets", kBadInput, "the document is a <<<<<<<<>", "<<<<<<<<");
  family.add("only_a_comment", kBadInput, "no XML element found", "<!-- <svg/> -->");
  family.add("only_an_instruction", kBadInput, "no XML element found", "<?xml version='1.0'?>");
  family.add("comment_without_end", kBadInput, "the XML is cut short", "<svg/><!-- ");
  family.add("cdata_without_end", kBadInput, "the XML is cut short", "<svg><![CDATA[ ");
  family.add("attribute_without_end", kBadInput, "not well-formed XML", "<svg viewBox='0 0 ");
  family.add("attribute_without_value", kBadInput, "the XML is cut short", "<svg viewBox/>");
  family.add("attribute_without_quotes", kBadInput, "not well-formed XML", "<svg width=9/>");
  family.add("end_without_begin", kBadInput, "not well-formed XML", "</svg>");
  family.add("ends_crossed", kBadInput, "not well-formed XML", svg("<g><a></g></a>"));
  family.add("ends_of_another", kBadInput, "not well-formed XML", "<svg></gvs>");
  family.add("other_root", kBadInput, "in.svg:1:1: error: the document is a <html>", "<html/>");
  family.add("root_of_a_long_name", kBadInput, "the document is a <aaaa",
             [] { return "<" + repeated("a", kMillion) + "/>"; });
  family.add("root_of_bytes", kBadInput, "the document is a <", "<\x01\x02\x1b[31m/>");
  for (std::size_t i = 0; i + 9 < good.size(); i += good.size() / 12) {
    family.add("cut_at_" + std::to_string(i), kBadInput, "in.svg", good.substr(0, i));
  }
}

void add_large(Family& family) {
  family.add("a_million_open_brackets", kBadInput, "the document is a <<<<<<",
             [] { return repeated("<", kMillion); });
  family.add("a_million_elements", kDone, "the document has no layer",
             [] { return svg(repeated("<g/>", kMillion)); });
  family.add("a_million_comments", kDone, "",
             [] { return svg(repeated("<!---->", kMillion) + kLayer); });
  family.add("a_million_instructions", kDone, "",
             [] { return svg(repeated("<?a?>", kMillion) + kLayer); });
  family.add("a_million_texts", kDone, "",
             [] { return svg(repeated("a<!---->", kMillion) + kLayer); });
  family.add("a_million_cdatas", kDone, "",
             [] { return svg(repeated("<![CDATA[]]>", kMillion) + kLayer); });
  family.add("a_comment_of_32_mib", kDone, "",
             [] { return svg("<!--" + std::string(32 << 20, '-') + " -->" + kLayer); });
  family.add("blanks_of_32_mib", kDone, "",
             [] { return svg(std::string(32 << 20, ' ') + kLayer); });
  family.add("lines_of_16_mib", kDone, "",
             [] { return svg(std::string(16 << 20, '\n') + kLayer); });
  family.add("longer_than_the_limit", kLimit, "more than the limit of 67108864 bytes",
             [] { return svg(std::string(65 << 20, ' ') + kLayer); });
  family.add("more_elements_than_the_limit", kLimit, "more than the limit of",
             [] { return svg(repeated("<g/>", 8'100'000)); });
  family.add("attributes_200000_on_one_element", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + numbered(" a", 200'000, "='b'") + "/>" + kLayer); });
  family.add("attributes_200000_on_the_root", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg(kLayer, numbered(" a", 200'000, "=''")); });
  family.add("attributes_200000_of_one_name", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + repeated(" a='b'", 200'000) + "/>" + kLayer); });
  family.add("attributes_of_ours_200000", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + repeated(" sf:diffuse='false'", 200'000) + "/>" + kLayer); });
  family.add("attribute_of_16_mib", kDone, "",
             [] { return svg("<g title='" + std::string(16 << 20, 'x') + "'/>" + kLayer); });
  family.add("attribute_name_of_16_mib", kDone, "",
             [] { return svg("<g " + std::string(16 << 20, 'x') + "='1'/>" + kLayer); });
  family.add("element_name_of_16_mib", kDone, "is not read; such elements are ignored",
             [] { return svg("<" + std::string(16 << 20, 'x') + "/>" + kLayer); });
  family.add("unknown_elements_of_100000_names", kDone, "warning: and 99900 more of other kinds",
             [] { return svg(numbered("<e", 100'000, "/>") + kLayer); });
  family.add("unknown_elements_behind_16_mib_of_one_line", kDone, "and 100 more of other kinds",
             [] {
               return svg("<!--" + std::string(16 << 20, ' ') + "-->" + numbered("<e", 200, "/>") +
                          kLayer);
             });
  family.add("unknown_elements_before_and_behind_16_mib", kDone, "and 20 more of other kinds", [] {
    return svg("<g>" + numbered("<e", 60, "/>") + "</g><!--" + std::string(16 << 20, '\n') +
               "--><g>" + numbered("<f", 60, "/>") + "</g>" + kLayer);
  });
}

void add_deep(Family& family) {
  const auto nested = [](std::size_t depth, const char* name) {
    return [depth, name] {
      return svg(repeated("<" + std::string(name) + ">", depth) +
                 repeated("</" + std::string(name) + ">", depth) + kLayer);
    };
  };
  family.add("nested_to_the_limit", kDone, "", nested(255, "g"));
  family.add("nested_one_deeper", kLimit, "more than the limit of 256 elements within each other",
             nested(256, "g"));
  family.add("nested_a_million", kLimit, "more than the limit of 256 elements within each other",
             nested(kMillion, "g"));
  family.add("nested_svg_a_million", kLimit,
             "more than the limit of 256 elements within each other", nested(kMillion, "svg"));
  family.add("nested_unknown_a_million", kLimit,
             "more than the limit of 256 elements within each other", nested(kMillion, "x"));
  family.add("nested_in_another_namespace", kLimit,
             "more than the limit of 256 elements within each other", nested(kMillion, "x:x"));
  family.add("nested_a_million_without_end", kBadInput, "not well-formed XML",
             [] { return svg(repeated("<g>", kMillion)); });
  family.add("nested_a_million_in_the_root", kBadInput, "cut short",
             [] { return repeated("<svg>", kMillion); });
  family.add("nested_brackets_in_a_doctype", kDone, "",
             [] { return "<!DOCTYPE svg " + repeated("[", kMillion) + ">" + svg(kLayer); });
  family.add("nested_doctypes", kBadInput, "in.svg",
             [] { return repeated("<!DOCTYPE a [", kMillion) + svg(kLayer); });
}

void add_xml_cases(Family& family) {
  add_broken_xml(family);
  add_large(family);
  add_deep(family);
}

const Register kXml("xml", add_xml_cases);

}  // namespace
}  // namespace sfumato::hostile
