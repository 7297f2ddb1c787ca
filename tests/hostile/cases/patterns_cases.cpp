// Patterns: empty tiles, images outside, chains, and files that are not images.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"
#include "hostile/images.hpp"

namespace sfumato::hostile {
namespace {

/// Returns a pattern on line 3 whose image is the file t.
std::string pattern(const std::string& attributes, const std::string& image = "") {
  return painted("<pattern id='p' " + attributes + "><image href='t' " + image + "/></pattern>");
}

const std::string kTile = "patternUnits='userSpaceOnUse' width='9' height='9' ";

void add_patterns_cases(Family& family) {
  const auto add = [&](const char* name, int code, const char* message, Bytes document) {
    family.add(name, code, message, std::move(document)).with("t", good_png());
  };
  add("no_tile", kBadInput, "the pattern's tile has no area", pattern(""));
  add("tile_negative", kBadInput, "the pattern's tile has no area",
      pattern("patternUnits='userSpaceOnUse' width='-9' height='9'"));
  add("tile_tiny", kDone, "",
      pattern("patternUnits='userSpaceOnUse' width='1e-300' height='1e-300'"));
  add("tile_small", kDone, "",
      pattern("patternUnits='userSpaceOnUse' width='1e-4' height='1e-4'",
              "width='1e-4' height='1e-4'"));
  add("tile_huge", kDone, "does not cover the pattern's tile",
      pattern("patternUnits='userSpaceOnUse' width='9999999' height='9999999'"));
  add("repeats_of_a_word", kBadInput, "use true or false", pattern(kTile + "sf:repeats='x'"));
  add("tile_nan", kBadInput, "width of <pattern>", pattern("width='nan' height='1'"));
  add("units_unknown", kBadInput, "use userSpaceOnUse or objectBoundingBox",
      pattern("patternUnits='tile' width='1' height='1'"));
  add("image_of_no_size", kBadInput, "the <image> has no area",
      pattern(kTile, "width='0' height='9'"));
  add("image_negative", kBadInput, "the <image> has no area",
      pattern(kTile, "width='-1' height='-1'"));
  add("image_huge", kDone, "", pattern(kTile, "width='9999999' height='9999999'"));
  add("image_tiny", kBadInput, "the pattern's place cannot be computed",
      pattern(kTile, "width='1e-300' height='1e-300'"));
  add("image_far_away", kBadInput, "the <image> begins outside of its tile",
      pattern(kTile, "x='-9999999' width='9' height='9'"));
  add("image_mirrored", kBadInput, "is turned or mirrored",
      pattern(kTile, "width='9' height='9' transform='scale(-1 1)'"));
  add("image_turned", kBadInput, "is turned or mirrored",
      pattern(kTile, "width='9' height='9' transform='rotate(45)'"));
  add("image_flat", kBadInput, "in.svg:3",
      pattern(kTile, "width='9' height='9' transform='scale(0)'"));
  add("aspect_unknown", kBadInput, "preserveAspectRatio of <image>",
      pattern(kTile, "width='9' height='9' preserveAspectRatio='xMidYMid stretch'"));
  add("view_box_of_words", kBadInput, "viewBox of <pattern>", pattern(kTile + "viewBox='a b c d'"));
  add("view_box_tiny", kBadInput, "in.svg:3", pattern(kTile + "viewBox='0 0 1e-300 1e-300'"));
  add("transform_flat", kBadInput, "cannot be inverted",
      pattern(kTile + "patternTransform='scale(0)'"));
  add("transform_tiny", kDone, "",
      pattern(kTile + "patternTransform='scale(1e-6)'", "width='9' height='9'"));
  add("transform_huge", kDone, "",
      pattern(kTile + "patternTransform='scale(1e6)'", "width='9' height='9'"));
  add("transform_skewed", kDone, "",
      pattern(kTile + "patternTransform='matrix(1 1 1 1.0001 0 0)'", "width='9' height='9'"));
  add("no_image", kBadInput, "use exactly one <image>", painted("<pattern id='p'/>"));
  add("two_images", kBadInput, "use exactly one <image>",
      painted("<pattern id='p'><image href='t'/><image href='t'/></pattern>"));
  add("images_100000", kBadInput, "use exactly one <image>", [] {
    return painted("<pattern id='p'>" + repeated("<image href='t'/>", 100'000) + "</pattern>");
  });
  add("a_rect", kBadInput, "use exactly one <image>",
      painted("<pattern id='p'><rect width='9' height='9'/></pattern>"));
  add("a_pattern_in_a_pattern", kBadInput, "use exactly one <image>",
      [] { return painted(repeated("<pattern id='p'>", 200) + repeated("</pattern>", 200)); });
  add("patterns_that_paint_each_other_10_to_12", kBadInput, "use exactly one <image>", [] {
    std::string patterns;
    for (int i = 0; i < 12; ++i) {
      patterns += "<pattern id='p" + (i == 0 ? "" : std::to_string(i)) +
                  "' width='.1' height='.1'><rect width='9' height='9' fill='url(#p" +
                  std::to_string(i + 1) + ")'/></pattern>";
    }
    return painted(patterns);
  });
  add("of_itself", kBadInput, "go round in a circle: #p → #p",
      painted("<pattern id='p' href='#p'/>"));
  add("chain_of_300", kLimit, "paints that inherit from each other", [] {
    std::string chain = "<pattern id='p' href='#p1'/>";
    for (int i = 1; i < 300; ++i) {
      chain += "<pattern id='p" + std::to_string(i) + "' href='#p" + std::to_string(i + 1) + "'/>";
    }
    return painted(chain + "<pattern id='p300'/>");
  });
  add("image_without_href", kBadInput, "<image> has no href",
      painted("<pattern id='p' " + kTile + "><image/></pattern>"));
  add("textures_300_of_one_file", kLimit, "more than the limit of 256 textures", [] {
    std::string curves;
    for (int i = 1; i <= 300; ++i) {
      curves +=
          "<path transform='scale(" + std::to_string(i) + " 1)' d='M0 0h1v1' sf:left='url(#p)'/>";
    }
    return svg("<g sf:diffuse='true'>" + curves + "</g><pattern id='p' " + kTile +
               "><image href='t' width='9' height='9'/></pattern>");
  });
  add("one_texture_of_20000_curves", kDone, "", [] {
    return svg(
        "<g sf:diffuse='true'>" + repeated("<path d='M9 9h80v9' sf:left='url(#p)'/>", 20'000) +
        "</g><pattern id='p' " + kTile + "><image href='t' width='9' height='9'/></pattern>");
  });
}

const Register kPatterns("patterns", add_patterns_cases);

}  // namespace
}  // namespace sfumato::hostile
