// Document types and entities: expansion is limited, and nothing is fetched.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string typed(const std::string& declarations, const std::string& content) {
  return "<!DOCTYPE svg [" + declarations + "]>" + svg(content + kLayer);
}

std::string laughing_entities(int levels) {
  std::string entities = "<!ENTITY a0 'ha'>";
  for (int i = 1; i <= levels; ++i) {
    entities += "<!ENTITY a" + std::to_string(i) + " '" +
                repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
  }
  return entities;
}

void add_entities_cases(Family& family) {
  family.add("billion_laughs", kLimit,
             "bytes of entities; raise the limit with --limit entity-bytes=N",
             [] { return typed(laughing_entities(9), "<g id='&a9;'>&a9;</g>"); });
  family.add("billion_laughs_about_nothing", kLimit, "bytes of entities", [] {
    std::string entities = laughing_entities(9);
    return typed(entities.replace(entities.find("ha"), 2, ""), "<g id='&a9;'>&a9;</g>");
  });
  family.add("quadratic_blowup", kLimit, "bytes of entities", [] {
    return typed("<!ENTITY a '" + repeated("x", 100'000) + "'>",
                 "<g>" + repeated("&a;", 20'000) + "</g>");
  });
  family.add("quadratic_blowup_in_an_attribute", kLimit, "bytes of entities", [] {
    return typed("<!ENTITY a '" + repeated("x", 100'000) + "'>",
                 "<g title='" + repeated("&a;", 20'000) + "'/>");
  });
  family.add("entity_as_path_data", kLimit, "bytes of entities", [] {
    return typed("<!ENTITY a '" + repeated("h1", 100'000) + "'>",
                 "<g sf:diffuse='true'><path d='M0 0" + repeated("&a;", 20'000) + "'/></g>");
  });
  family.add("entities_of_elements", kDone, "", [] {
    return typed("<!ENTITY a \"" + repeated("<g/>", 1'000) + "\">", repeated("&a;", 250));
  });
  family.add("entities_of_tags_unfinished", kBadInput, "ends within a tag",
             typed("<!ENTITY a '<g'>", "&a;/>"));
  family.add("entities_a_million", kDone, "",
             [] { return typed("<!ENTITY a ''>", repeated("&a;", kMillion)); });
  family.add("entities_declared_a_million", kDone, "",
             [] { return typed(numbered("<!ENTITY a", kMillion, " '&#38;b;'>"), "&a7;"); });
  family.add("entities_deep", kLimit, "entities within each other; --limit entity-depth=N", [] {
    std::string entities;
    for (int i = 0; i < 1'000; ++i) {
      entities += "<!ENTITY a" + std::to_string(i) + " '&a" + std::to_string(i + 1) + ";'>";
    }
    return typed(entities, "<g id='&a0;'/>");
  });
  family.add("parameter_entities", kDone, "parameter entities of a DTD are not read",
             typed("<!ENTITY % a '<!ENTITY b \"c\">'> %a; %a;", "&b;"));
  family.add("entity_of_itself", kLimit, "entities within each other",
             typed("<!ENTITY a '&a;'>", "&a;"));
  family.add("entities_of_each_other", kLimit, "entities within each other",
             typed("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "&a;"));
  family.add("external_file", kDone, "is external and is not read",
             typed("<!ENTITY a SYSTEM 'file:///etc/passwd'>", "<g id='&a;'>&a;</g>"));
  family.add("external_device", kDone, "is external and is not read",
             typed("<!ENTITY a SYSTEM 'file:///dev/zero'>", "<g>&a;</g>"));
  family.add("external_url", kDone, "is external and is not read",
             typed("<!ENTITY a SYSTEM 'http://127.0.0.1:1/'>", "<g>&a;</g>"));
  family.add("external_file_as_href", kBadInput, "nothing is fetched",
             "<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>" + textured("file:&a;"));
  family.add("external_subset", kDone, "",
             "<!DOCTYPE svg SYSTEM 'file:///dev/zero'>" + svg(kLayer));
  family.add("external_subset_public", kDone, "",
             "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://127.0.0.1:1/'>" + svg(kLayer));
  family.add("attributes_by_default", kDone, "",
             typed("<!ATTLIST g sf:diffuse CDATA 'true'>", "<g/>"));
  family.add("unknown_entity", kDone, "", typed("", "<g id='&nothing;'>&nothing;</g>"));
  family.add("unknown_entities_a_million", kDone, "",
             [] { return svg(repeated("&a;", kMillion) + kLayer); });
  family.add("references_a_million", kDone, "",
             [] { return svg(repeated("&#65;", kMillion) + kLayer); });
  family.add("reference_beyond_unicode", kDone, "", svg("&#x110000;&#xFFFFFFFF;" + kLayer));
  family.add("reference_of_a_million_digits", kDone, "",
             [] { return svg("&#" + repeated("9", kMillion) + ";" + kLayer); });
  family.add("reference_to_a_surrogate", kDone, "", svg("&#xD800;&#xDFFF;" + kLayer));
  family.add("reference_without_end", kDone, "", svg("&#65 &#x &# & &amp" + kLayer));
  family.add("reference_to_a_bracket", kDone, "", svg("&#60;g&#62;&lt;g&gt;" + kLayer));
  family.add("doctype_without_end", kBadInput, "in.svg", "<!DOCTYPE svg [" + svg(kLayer));
  family.add("doctype_of_quotes", kBadInput, "in.svg", "<!DOCTYPE svg '>" + svg(kLayer));
  family.add("doctype_twice", kDone, "", "<!DOCTYPE svg><!DOCTYPE svg>" + svg(kLayer));
  family.add("doctype_of_16_mib", kDone, "", [] {
    return "<!DOCTYPE svg [" + repeated("<!ENTITY a 'b'>", kMillion) + "]>" + svg(kLayer);
  });
  family.add("stylesheet_instruction", kDone, "",
             "<?xml-stylesheet href='file:///dev/zero'?>" + svg(kLayer));
  family.add("xinclude", kDone, "",
             svg("<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' "
                 "href='file:///etc/passwd' parse='text'/>" +
                 kLayer));
  family.add(
      "xinclude_of_itself", kDone, "",
      svg("<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='in.svg'/>" + kLayer));
}

const Register kEntities("entities", add_entities_cases);

}  // namespace
}  // namespace sfumato::hostile
