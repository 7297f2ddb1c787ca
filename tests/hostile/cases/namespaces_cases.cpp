// Prefixes that are undeclared, declared twice, or declared as something else.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

const std::string kSpace = "xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' ";

void add_namespaces_cases(Family& family) {
  family.add("prefix_not_declared", kBadInput, "the prefix sf is not declared",
             "<svg " + kSpace + "sf:version='1'/>");
  family.add("prefix_declared_below", kBadInput, "the prefix sf is not declared",
             "<svg " + kSpace + "sf:version='1'><g xmlns:sf='urn:sfumato:1'/></svg>");
  family.add("another_version", kBadInput, "the namespace \"urn:sfumato:2\" is not known",
             "<svg " + kSpace + "xmlns:sf='urn:sfumato:2'/>");
  family.add("another_version_long", kBadInput, "is not known", [] {
    return "<svg " + kSpace + "xmlns:sf='urn:sfumato:" + repeated("1", kMillion) + "'/>";
  });
  family.add("element_of_ours", kBadInput, "the namespace urn:sfumato:1 has attributes only",
             svg("<sf:path/>" + kLayer));
  family.add("other_prefix", kDone, "",
             "<svg " + kSpace +
                 "xmlns:q='urn:sfumato:1' q:version='1'><g q:diffuse='true'><path d='M1 1h5' "
                 "q:left='red'/></g></svg>");
  family.add("prefix_redeclared", kDone, "",
             svg("<g xmlns:sf='urn:other'><g sf:nonsense='1'/></g>" + kLayer));
  family.add("svg_by_a_prefix", kDone, "",
             "<s:svg xmlns:s='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 9 "
             "9' sf:version='1'><s:g sf:diffuse='true'><s:path d='M1 1h5' "
             "sf:left='red'/></s:g></s:svg>");
  family.add("default_is_ours", kDone, "it is read as version 1",
             "<svg xmlns='urn:sfumato:1' viewBox='0 0 9 9'/>");
  family.add("name_of_colons", kDone, "<::> is not read", svg("<:/><::/><a:/><:a/>" + kLayer));
  family.add("attribute_of_colons", kDone, "", svg("<g :='1' ::='1' a:='1' :left='1'/>" + kLayer));
  family.add("attribute_of_a_bare_prefix", kBadInput,
             "there is no attribute sf:", svg("<g sf:='1'/>" + kLayer));
  family.add("two_prefixes_of_ours", kBadInput, "given twice",
             svg("<g xmlns:q='urn:sfumato:1' q:diffuse='true' sf:diffuse='true'><path d='M9 9h9' "
                 "sf:left='red' q:left='blue'/></g>"));
  family.add("declarations_200000_on_one_element", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + numbered(" xmlns:a", 200'000, "='b'") + "/>" + kLayer); });
  family.add("declarations_200000_of_one_prefix", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + repeated(" xmlns:a='b'", 200'000) + "/>" + kLayer); });
  family.add("declarations_at_every_depth", kDone, "", [] {
    std::string open;
    for (int i = 0; i < 200; ++i) open += "<g" + numbered(" xmlns:a", 500, "='b'") + ">";
    return svg(open + repeated("</g>", 200) + kLayer);
  });
  family.add("elements_of_200000_prefixes", kDone, "",
             [] { return svg(numbered("<a", 200'000, ":b/>") + kLayer); });
  family.add("prefix_of_16_mib", kDone, "",
             [] { return svg("<" + std::string(16 << 20, 'a') + ":b/>" + kLayer); });
  family.add("uri_of_16_mib", kDone, "",
             [] { return svg("<g xmlns:a='" + std::string(16 << 20, 'a') + "'/>" + kLayer); });
  family.add("hrefs_200000_on_one_element", kLimit,
             "more than the limit of 1024 attributes of one element",
             [] { return svg("<g" + repeated(" xlink:href='#a'", 200'000) + "/>" + kLayer); });
  family.add("removed_elements_a_million", kDone, "",
             [] { return svg(repeated("<o:o/>", kMillion) + kLayer); });
  family.add("removed_trees", kDone, "", [] {
    return svg(repeated(repeated("<o:o>", 200) + repeated("</o:o>", 200), 2000) + kLayer);
  });
}

const Register kNamespaces("namespaces", add_namespaces_cases);

}  // namespace
}  // namespace sfumato::hostile
