#include "allocation/documents.hpp"

#include "formats/image_files.hpp"
#include "support/gzip.hpp"

namespace sfumato::test {
namespace {

constexpr const char* kColors =
    R"x(<g sf:diffuse="true"><path d="M-1 5 C5 2 9 8 17 4" sf:left="red, gold 30%, blue" )x"
    R"x(sf:right="#264"/></g>)x";

constexpr const char* kOpacity =
    R"x(<g sf:diffuse="true"><circle cx="8" cy="6" r="4" sf:left="red" sf:right="blue" )x"
    R"x(sf:left-opacity="0" sf:right-opacity="1, .5 50%, 1"/></g>)x";

constexpr const char* kBlur =
    R"x(<g sf:diffuse="true"><path d="M-1 5 L17 4" sf:left="red" sf:right="blue" )x"
    R"x(sf:blur="0, 2 50%, 0" sf:weight="2"/></g>)x";

constexpr const char* kGradient =
    R"x(<defs><radialGradient id="r" gradientUnits="userSpaceOnUse" cx="8" cy="6" r="6">)x"
    R"x(<stop offset="0" stop-color="red"/><stop offset="1" stop-color="#0088ff"/>)x"
    R"x(</radialGradient></defs>)x"
    R"x(<g sf:diffuse="true"><path d="M-1 5 L17 4" sf:left="url(#r)" sf:right="gold"/></g>)x";

constexpr const char* kGroups =
    R"x(<style>.soft{opacity:.5}</style><g style="mix-blend-mode:multiply" class="soft">)x"
    R"x(<g id="layer" sf:diffuse="true"><path d="M-1 5 L17 4" sf:left="red" sf:right="blue"/></g>)x"
    R"x(<use href="#layer" transform="translate(4 3) rotate(20)" opacity=".8"/></g>)x";

constexpr const char* kLocalCurve =
    R"x(<path d="M2 3 C6 1 9 9 14 5" sf:radius="2, 1" sf:left="red" sf:right="blue, gold"/>)x";

constexpr const char* kWarned =
    R"x(<text>ignored</text><g sf:diffuse="true" filter="url(#f)"><path d="M0 0 L9 9" )x"
    R"x(sf:left="red"/></g>)x";

std::string pattern(const char* id, const std::string& uri) {
  return std::string("<defs><pattern id=\"") + id +
         R"x(" patternUnits="userSpaceOnUse" width="8" height="8"><image href=")x" + uri +
         R"x(" width="8" height="8"/></pattern></defs><g sf:diffuse="true"><path d="M-1 5 L17 4" )x"
         "sf:left=\"url(#" +
         id + R"x()" sf:right="blue"/></g>)x";
}

std::string png_texture() {
  return pattern("png", "data:image/png;base64," + base64_of(png_file(3, 2)));
}

std::string jpeg_texture() {
  return pattern("jpeg",
                 "data:image/jpeg;base64," + base64_of(jpeg_file(9, 8, 3, {200, 60, 20}, true)));
}

std::string svg(const std::string& content) {
  return R"x(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" )x"
         R"x(viewBox="0 0 16 12" sf:version="1">)x" +
         content + "</svg>";
}

constexpr const char* kOrzan =
    R"x(<curve_set image_width="16" image_height="12"><curve><control_points_set>)x"
    R"x(<control_point x="2" y="3"/><control_point x="8" y="4"/><control_point x="3" y="9"/>)x"
    R"x(<control_point x="9" y="14"/></control_points_set>)x"
    R"x(<left_colors_set><left_color R="20" G="40" B="200" globalID="0"/></left_colors_set>)x"
    R"x(<right_colors_set><right_color R="200" G="40" B="20" globalID="5"/></right_colors_set>)x"
    R"x(<blur_points_set><best_scale value="1" globalID="0"/></blur_points_set>)x"
    R"x(</curve></curve_set>)x";

}  // namespace

std::vector<SmallDocument> small_documents() {
  return {{"colors", svg(kColors)},
          {"opacity", svg(kOpacity)},
          {"blur", svg(kBlur)},
          {"gradient", svg(kGradient)},
          {"groups", svg(kGroups)},
          {"local_curve", svg(kLocalCurve)},
          {"png_texture", svg(png_texture())},
          {"jpeg_texture", svg(jpeg_texture())},
          {"warnings", svg(kWarned)},
          {"orzan", kOrzan},
          {"packed", gzipped(svg(kColors))}};
}

std::string small_document_for_outputs() {
  return svg(std::string(kGroups) + kLocalCurve);
}

std::string document_with_everything() {
  return svg(std::string(kColors) + kOpacity + kBlur + kGradient + kGroups + png_texture() +
             jpeg_texture() + kLocalCurve + kWarned);
}

}  // namespace sfumato::test
