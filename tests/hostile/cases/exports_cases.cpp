// Documents that are hard for exporters, in every output.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

struct Odd {
  const char* name;
  const char* warning;  ///< the expected message
  std::string (*document)();
};

const Odd kOdd[] = {
    {"empty", "the picture is empty", [] { return svg(""); }},
    {"nothing_seen", "", [] { return layer("<path d='M1e7 1e7h-1' sf:left='red'/>"); }},
    {"title", "",
     [] {
       return svg(
           "<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt; ]]&gt; --&gt; "
           "\\)(</title>" +
           kLayer);
     }},
    {"ids", "",
     [] {
       return svg(
           "<g sf:diffuse='true' id='&lt;/script>\"&#39;\\)\xff'><path id='&lt;!--' d='M9 "
           "9h80' sf:left='red'/></g>");
     }},
    {"nested_groups", "",
     [] {
       return svg(repeated("<g opacity='.9' style='mix-blend-mode:hue'>", 15) + kLayer + kStroke +
                  repeated("</g>", 15));
     }},
    {"instances", "",
     [] {
       return svg("<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
                  numbered("<use href='#a' opacity='.5' x='", 30, "'/>"));
     }},
    {"translucent", "",
     [] {
       return layer(
           "<path d='M9 9h80' sf:left='red' sf:right='blue' sf:left-opacity='0, 1' "
           "sf:right-opacity='1e-30' sf:blur='0, 9'/>");
     }},
    {"far", "", [] { return path("M-1e7-1e7L1e7 1e7M-1e7 1e7L1e7-1e7"); }},
    {"dense", "", [] { return path(repeated("M9 9C90 9 9 40 90 40", 500)); }},
    {"strokes", "", [] { return svg(repeated(kStroke, 500)); }},
    {"texture", "", [] { return textured("data:image/png;base64," + base64(good_png())); }},
    {"steep_gradient", "",
     [] {
       return painted(
           "<linearGradient id='p' gradientUnits='userSpaceOnUse' x2='.01' "
           "spreadMethod='repeat'><stop/><stop offset='1' stop-color='red'/>"
           "</linearGradient>");
     }},
};

void add_exports_cases(Family& family) {
  for (const Odd& odd : kOdd) {
    for (const char* output :
         {"png", "jpg", "webp", "html", "pdf", "eps", "svg", "glb", "sfv", "npz", "ply", "json"}) {
      const std::string name = std::string(odd.name) + "_as_" + output;
      family.add(name, kDone, "", odd.document)
          .run({"render", "in.svg", "--quiet", "-o", std::string("out.") + output});
    }
    family.add(std::string(odd.name) + "_as_vector_svg", kDone, "", odd.document)
        .run({"render", "in.svg", "--quiet", "--svg", "vector", "-o", "out.svg"});
    family.add(std::string(odd.name) + "_converted", kDone, odd.warning, odd.document)
        .run({"convert", "in.svg", "-o", "out.svg"});
    family.add(std::string(odd.name) + "_by_rays", kDone, odd.warning, odd.document)
        .also({"--method", "rays", "--rays", "4"});
    family.add(std::string(odd.name) + "_by_pixels", kDone, odd.warning, odd.document)
        .also({"--method", "pixels"});
  }
}

const Register kExports("exports", add_exports_cases);

}  // namespace
}  // namespace sfumato::hostile
