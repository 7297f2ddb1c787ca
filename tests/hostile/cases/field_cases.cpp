// Attacks that broke other programs, with the figures of their reports (README.md), each as close
// to the original as this format allows.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

std::string plain(const std::string& content, const std::string& size = "width='64' height='64'") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " +
         size + ">" + content + "</svg>";
}

/// Other programs can draw each of them, because they use nothing of Sfumato's format.
void add_field_cases(Family& family) {
  const char* empty = "the picture is empty";
  const char* not_read = "is not read";
  const char* entities = "more than the limit of 1048576 bytes of entities";
  family.add("attributes_200000", kLimit, "more than the limit of 1024 attributes of one element",
             [] { return plain("<rect" + numbered(" a", 200'000, "='b'") + "/>"); });
  family.add("entity_of_100_kb_20000_times", kLimit, entities, [] {
    return "<!DOCTYPE svg [<!ENTITY a '" + repeated("x", 100'000) + "'>]>" +
           plain("<desc>" + repeated("&a;", 20'000) + "</desc>");
  });
  family.add("turbulence_of_2e9_octaves", kDone, not_read,
             plain("<filter id='f'><feTurbulence baseFrequency='.1' numOctaves='2000000000'/>"
                   "</filter><rect width='64' height='64' filter='url(#f)'/>"));
  family.add("blanks_of_2_gib_packed", kLimit, "unpacks to more than the limit of",
             [] { return gzip_of_byte(' ', std::size_t{2} << 30); });
  family.add("gigapixel", kLimit, "the limit is 16384 pixels on a side",
             plain("<rect width='9' height='9'/>", "width='32000' height='32000'"));
  family.add("size_60000", kLimit, "the limit is 16384 pixels on a side",
             plain("<rect width='9' height='9'/>", "width='60000' height='60000'"));
  family.add("png_that_lies_about_60000", kDone, empty, [] {
    return plain("<image width='64' height='64' xlink:href='data:image/png;base64," +
                 base64(png_header({60'000, 60'000}) + png_chunk("IDAT", zlib_packed("x")) +
                        png_chunk("IEND", "")) +
                 "'/>");
  });
  family.add("png_that_lies_about_60000_as_texture", kLimit, "the limit is 16384 pixels on a side",
             [] {
               return textured("data:image/png;base64," +
                               base64(png_header({60'000, 60'000}) +
                                      png_chunk("IDAT", zlib_packed("x")) + png_chunk("IEND", "")));
             });
  family.add("png_of_zeros_20000", kLimit, "the limit is 16384 pixels on a side", [] {
    return textured("data:image/png;base64," +
                    base64(png_of_zeros({20'000, 20'000, 8, 2}, 60'000)));
  });
  family.add("patterns_nested_10_to_12", kDone, empty, [] {
    std::string patterns;
    for (int i = 0; i < 12; ++i) {
      patterns += "<pattern id='p" + std::to_string(i) +
                  "' width='.1' height='.1'><rect width='9' height='9' fill='url(#p" +
                  std::to_string(i + 1) + ")'/></pattern>";
    }
    return plain("<defs>" + patterns + "</defs><rect width='64' height='64' fill='url(#p0)'/>");
  });
  family.add("use_10_to_9", kLimit, "elements read through <use>",
             [] { return plain(laughs(9, "<rect width='1' height='1'/>") + "<use href='#g9'/>"); });
  family.add("use_10_to_9_by_xlink", kLimit, "elements read through <use>", [] {
    std::string groups = "<g id='g0'><rect/></g>";
    for (int i = 1; i <= 9; ++i) {
      groups += "<g id='g" + std::to_string(i) + "'>" +
                repeated("<use xlink:href='#g" + std::to_string(i - 1) + "'/>", 10) + "</g>";
    }
    return plain("<defs>" + groups + "</defs><use xlink:href='#g9'/>");
  });
  family.add("markers_400000", kDone, empty, [] {
    return plain("<marker id='m'><path d='M0 0h1'/></marker><path marker-mid='url(#m)' d='M0 0" +
                 repeated("h1", 400'000) + "'/>");
  });
  family.add("path_of_5_million_points", kDone, empty,
             [] { return plain("<path d='M0 0" + repeated("h1", 5'000'000) + "'/>"); });
  family.add("path_of_5_million_points_as_curve", kLimit, "more than the limit of 4000000 control",
             [] { return path("M0 0" + repeated("h1", 5'000'000)); });
  family.add("css_rules_2000_by_200_parts", kDone, empty, [] {
    std::string rules;
    for (int i = 0; i < 2000; ++i) rules += repeated("g ", 199) + "rect{fill:red}";
    return plain("<style>" + rules + "</style>" + repeated("<g>", 200) + "<rect/>" +
                 repeated("</g>", 200));
  });
  family.add("groups_nested_a_million", kLimit,
             "more than the limit of 256 elements within each other",
             [] { return plain(repeated("<g>", kMillion) + repeated("</g>", kMillion)); });
  family.add("billion_laughs", kLimit, entities, [] {
    std::string declared = "<!ENTITY a0 'ha'>";
    for (int i = 1; i <= 9; ++i) {
      declared += "<!ENTITY a" + std::to_string(i) + " '" +
                  repeated("&a" + std::to_string(i - 1) + ";", 10) + "'>";
    }
    return "<!DOCTYPE svg [" + declared + "]>" + plain("<desc>&a9;</desc>");
  });
  family.add(
      "external_entity", kDone, empty,
      "<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>" + plain("<desc>&a;</desc>"));
  family.add("masks_nested", kDone, empty, [] {
    std::string masks;
    for (int i = 0; i < 50; ++i) {
      masks += "<mask id='m" + std::to_string(i) + "'><rect width='9' height='9' mask='url(#m" +
               std::to_string(i + 1) + ")'/></mask>";
    }
    return plain(masks + "<rect width='9' height='9' mask='url(#m0)'/>");
  });
  family.add("use_of_itself", kBadInput, "goes round in a circle",
             plain("<g id='a'><use xlink:href='#a'/></g>"));
  family.add("dashes_of_nothing", kDone, empty,
             plain("<path d='M0 0h1e6' stroke='red' stroke-dasharray='1e-9'/>"));
  family.add("blur_of_1e6", kDone, not_read,
             plain("<filter id='f'><feGaussianBlur stdDeviation='1000000'/></filter><rect "
                   "width='9' height='9' filter='url(#f)'/>"));
}

const Register kField("field", add_field_cases);

}  // namespace
}  // namespace sfumato::hostile
