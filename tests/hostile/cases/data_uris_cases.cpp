// Textures in data: URIs.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

std::string data(const std::string& text) {
  return textured("data:image/png;base64," + text);
}

void add_data_uris_cases(Family& family) {
  const std::string good = base64(good_png());
  family.add("good", kDone, "", data(good));
  family.add("without_type", kDone, "", textured("data:;base64," + good));
  family.add("of_another_type", kDone, "", textured("data:text/html;base64," + good));
  family.add("in_capitals", kDone, "", textured("DATA:IMAGE/PNG;BASE64," + good));
  family.add("with_blanks", kDone, "",
             data("&#10;\n\t " + good.substr(0, 40) + "\r\n" + good.substr(40)));
  family.add("percent_encoded", kDone, "", data(good.substr(0, 10) + "%" + [](char c) {
               const char* d = "0123456789ABCDEF";
               return std::string{d[(c >> 4) & 15], d[c & 15]};
             }(good[10]) + good.substr(11)));
  family.add("without_comma", kBadInput, "no comma", textured("data:image/png;base64"));
  family.add("empty", kBadInput, "neither a PNG nor a JPEG", data(""));
  family.add("of_nothing", kBadInput, "neither a PNG nor a JPEG", textured("data:,"));
  family.add("bare", kBadInput, "no comma", textured("data:"));
  family.add("padded", kBadInput, "neither a PNG nor a JPEG", data("===="));
  family.add("padded_a_million", kBadInput, "neither a PNG nor a JPEG",
             [] { return data(repeated("=", kMillion)); });
  family.add("padding_in_the_middle", kBadInput, "the base64 is damaged", data("AA==" + good));
  family.add("cut_in_a_digit", kBadInput, "href of <image>", data(good.substr(0, 41)));
  family.add("cut", kBadInput, "the PNG image is damaged", data(good.substr(0, 80)));
  family.add("letters_of_unicode", kBadInput, "the base64 is damaged", data("ÄÖÜ" + good));
  family.add("of_the_web", kBadInput, "the base64 is damaged", data("-_" + good));
  family.add("of_24_mb_of_zeros", kBadInput, "neither a PNG nor a JPEG",
             [] { return data(repeated("AAAA", 6'000'000)); });
  family.add("of_blanks", kBadInput, "neither a PNG nor a JPEG",
             [] { return data(repeated(" ", 8 << 20)); });
  family.add("of_percents", kBadInput, "neither a PNG nor a JPEG",
             [] { return textured("data:," + repeated("%41", kMillion)); });
  family.add("of_broken_percents", kBadInput, "neither a PNG nor a JPEG",
             [] { return textured("data:," + repeated("%", kMillion)); });
  family.add("header_of_a_megabyte", kDone, "", [good] {
    return textured("data:" + repeated("a=b;", kMillion / 4) + "base64," + good);
  });
  family.add("an_svg", kBadInput, "neither a PNG nor a JPEG",
             [] { return textured("data:image/svg+xml;base64," + base64(svg(kLayer))); });
  family.add("a_data_uri", kBadInput, "neither a PNG nor a JPEG",
             [] { return textured("data:;base64," + base64("data:;base64,AAAA")); });
  family.add("lying_png", kLimit, "the limit is 16384 pixels on a side", [] {
    return data(base64(png_header({60'000, 60'000}) + png_chunk("IEND", "")));
  });
  family.add("bomb", kLimit, "the limit is 16384 pixels on a side", [] {
    return data(base64(png_of_zeros({20'000, 20'000, 8, 0}, 20'000)));
  });
  family
      .add("long_one_of_20000_curves", kDone, "",
           [] {
             const std::string image =
                 png({}, std::string(720, '\0'), png_chunk("abCd", std::string(kMillion, 'x')));
             return svg(
                 "<g sf:diffuse='true'>" +
                 repeated("<path d='M9 9h8v9' sf:left='url(#p)'/>", 20'000) +
                 "</g><pattern id='p' patternUnits='userSpaceOnUse' width='4' height='4'><image "
                 "href='data:;base64," +
                 base64(image) + "' width='4' height='4'/></pattern>");
           })
      .run({"info", "in.svg"});
  family.add("the_same_256_times", kDone, "", [good] {
    std::string curves, patterns;
    for (int i = 0; i < 60; ++i) {
      curves += "<path d='M9 9h8v9' sf:left='url(#p" + std::to_string(i) + ")'/>";
      patterns +=
          "<pattern id='p" + std::to_string(i) +
          "' patternUnits='userSpaceOnUse' width='4' height='4'><image href='data:;base64," + good +
          "' width='4' height='4'/></pattern>";
    }
    return svg("<g sf:diffuse='true'>" + curves + "</g>" + patterns);
  });
}

const Register kDataUris("data_uris", add_data_uris_cases);

}  // namespace
}  // namespace sfumato::hostile
