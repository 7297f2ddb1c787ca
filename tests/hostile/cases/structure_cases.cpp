// The root, its settings, and the order of elements.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string root(const std::string& attributes, const std::string& content = kLayer) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' " + attributes + ">" +
         content + "</svg>";
}

void add_view_boxes(Family& family) {
  const auto box = [](const std::string& text) {
    return root("sf:version='1' viewBox='" + text + "'");
  };
  for (const auto& [name, text] : {std::pair("empty", ""),
                                   {"three_numbers", "0 0 1"},
                                   {"five_numbers", "0 0 1 1 1"},
                                   {"words", "a b c d"},
                                   {"nan", "0 0 nan 1"},
                                   {"commas", ",,,"},
                                   {"no_width", "0 0 0 9"},
                                   {"no_height", "0 0 9 0"},
                                   {"negative_width", "0 0 -9 9"},
                                   {"huge", "0 0 1e308 1"},
                                   {"infinite", "0 0 inf inf"},
                                   {"far_away", "1e308 0 9 9"},
                                   {"beyond_coordinates", "9999999 0 9 9"},
                                   {"units", "0px 0px 9px 9px"},
                                   {"percent", "0 0 100% 100%"}}) {
    family.add(std::string("view_box_") + name, kBadInput, "viewBox of <svg>", box(text));
  }
  family.add("view_box_of_a_million_numbers", kBadInput, "viewBox of <svg>",
             [box] { return box(repeated("1 ", kMillion)); });
  family.add("view_box_vanishing", kBadInput, "a viewport too small or too far away to be drawn",
             box("0 0 1e-320 1e-320"));
  family.add("view_box_tiny", kDone, "", box("0 0 1e-3 1e-3")).also({"--width", "9"});
  family.add("view_box_tiny_at_scale_1", kDone, "", box("0 0 1e-3 1e-3"));
  family.add("view_box_as_large_as_allowed", kLimit, "the limit is 16384 pixels on a side",
             box("-10000000 -10000000 10000000 10000000"));
  family.add("view_box_flat", kDone, "", box("0 0 1000 1e-6"));
  family.add("view_box_flat_and_far", kDone, "", box("9999000 9999999 900 .001"));
  family.add("view_box_thin", kLimit, "the limit is 16384 pixels on a side",
             box("0 0 1e-6 100000"));
}

void add_canvas_sizes(Family& family) {
  const auto size = [](const std::string& width, const std::string& height) {
    return root("sf:version='1' width='" + width + "' height='" + height + "'");
  };
  const auto beside = [](const std::string& given, const std::string& box) {
    return root("sf:version='1' " + given + " viewBox='" + box + "'");
  };
  family.add("size_enormous_beside_a_view_box", kLimit, "the limit is 16384 pixels on a side",
             beside("width='1e7' height='1e7'", "0 0 9 9"));
  family.add("size_of_an_endless_aspect", kBadInput, "the artboard has no area or is out of range",
             beside("width='1e7' height='1e-3'", "0 0 9 9"));
  family.add("size_beside_a_vanishing_view_box", kBadInput,
             "the artboard has no area or is out of range",
             beside("width='9' height='9'", "0 0 1e-320 1e-320"));
  family.add("size_that_is_none_beside_a_view_box", kDone, "the viewBox says the size",
             beside("width='none' height='9em' preserveAspectRatio='none of it'", "0 0 9 9"));
  family.add("no_size", kBadInput, "<svg> has no size", root("sf:version='1'"));
  family.add("width_alone", kBadInput, "<svg> has no size", root("width='9'"));
  family.add("size_of_nothing", kBadInput, "<svg> has no area", size("0", "0"));
  family.add("size_negative", kBadInput, "<svg> has no area", size("-9", "9"));
  family.add("size_nan", kBadInput, "width of <svg>", size("nan", "9"));
  family.add("size_of_nothing_known", kBadInput, "a share of nothing known", size("100%", "100%"));
  family.add("size_of_fonts", kBadInput, "width of <svg>", size("9em", "9ex"));
  family.add("size_of_a_gigapixel", kLimit, "the limit is 16384 pixels on a side",
             size("32000", "32000"));
  family.add("size_60000", kLimit, "the limit is 16384 pixels on a side", size("60000", "60000"));
  family.add("size_1e308", kBadInput, "width of <svg>", size("1e308", "1"));
  family.add("size_in_inches", kLimit, "the limit is 16384 pixels on a side",
             size("9999in", "9999in"));
}

void add_settings(Family& family) {
  const auto set = [](const std::string& attributes) {
    return root("viewBox='0 0 9 9' " + attributes);
  };
  family.add("version_missing", kDone, "it is read as version 1", set(""));
  family.add("version_2", kBadInput, "sf:version is \"2\"", set("sf:version='2'"));
  family.add("version_long", kBadInput, "sf:version is \"1111",
             [set] { return set("sf:version='" + repeated("1", kMillion) + "'"); });
  family.add("interpolation_unknown", kBadInput, "use srgb, linear or oklab",
             set("sf:interpolation='lab'"));
  family.add("background_url", kBadInput, "sf:background", set("sf:background='url(#a)'"));
  family.add("background_translucent", kBadInput, "use an opaque colour",
             set("sf:background='#12345678'"));
  family.add("settings_on_a_group", kBadInput, "belongs on the outermost <svg>",
             svg("<g sf:version='1'/>"));
  family.add("attribute_unknown", kBadInput, "did you mean sf:left?", curve("sf:lefft='red'"));
  family.add("attribute_unknown_long", kBadInput, "there is no attribute sf:aaaa",
             [] { return curve("sf:" + repeated("a", kMillion) + "='red'"); });
  family.add("attribute_unknown_in_defs", kBadInput, "there is no attribute sf:x",
             svg("<defs><g sf:x='1'/></defs>" + kLayer));
}

void add_places_of_elements(Family& family) {
  family.add("curve_outside_of_layers", kBadInput, "stands in no layer",
             svg("<path d='M0 0h9' sf:left='red'/>"));
  family.add("layer_in_a_layer", kBadInput, "is inside another layer",
             layer("<g sf:diffuse='true'/>"));
  family.add("local_curve_in_a_layer", kBadInput, "is a local curve and stands in",
             layer("<path d='M0 0h9' sf:left='red' sf:radius='1'/>"));
  family.add("diffuse_of_a_word", kBadInput, "use true or false", svg("<g sf:diffuse='TRUE'/>"));
  family.add("diffuse_on_the_root", kBadInput, "sf:diffuse on <svg> means nothing",
             svg(kLayer, "sf:diffuse='true'"));
  family.add("curve_attributes_on_a_group", kBadInput, "means nothing", svg("<g sf:left='red'/>"));
  family.add("nested_svg_of_nothing", kBadInput, "too large or too small",
             svg("<svg viewBox='0 0 1 1' width='0'/>" + kLayer));
  family.add("nested_svg_of_a_bad_box", kBadInput, "viewBox of <svg>",
             svg("<svg viewBox='a'/>" + kLayer));
  family.add("nested_svg_of_huge_boxes", kBadInput, "too large or too small", [] {
    return svg(repeated("<svg viewBox='0 0 .001 .001'>", 200) + kLayer + repeated("</svg>", 200));
  });
  family.add("script_and_style", kDone, "<foreignObject> is not read",
             svg("<script>while(1);</script><foreignObject/>" + kLayer));
  family.add("switch_and_text", kDone, "are ignored",
             svg("<switch><text>a</text></switch>" + kLayer));
  family.add("display_none_a_million_deep", kLimit,
             "more than the limit of 256 elements within each other", [] {
               return svg("<g display='none'>" + repeated("<g>", kMillion) +
                          repeated("</g>", kMillion) + "</g>");
             });
  family.add("filters_of_the_field", kDone, "filter of <g> is not read",
             svg("<filter id='f'><feTurbulence numOctaves='2000000000'/></filter><g "
                 "filter='url(#f)'>" +
                 kLayer + "</g>"));
  family
      .add("markers_400000", kDone, "",
           [] {
             return svg(
                 "<marker id='m'><path d='M0 0h1'/></marker><path fill='none' "
                 "marker-mid='url(#m)' d='M0 0" +
                 repeated("h1", 400'000) + "'/>" + kLayer);
           })
      .message = "has no attribute of Sfumato and is ignored";
  family.add("masks_nested", kDone, "mask of <g> is not read", [] {
    return svg("<mask id='m'><rect mask='url(#m)'/></mask><g mask='url(#m)'>" + kLayer + "</g>");
  });
}

void add_structure_cases(Family& family) {
  add_view_boxes(family);
  add_canvas_sizes(family);
  add_settings(family);
  add_places_of_elements(family);
}

const Register kStructure("structure", add_structure_cases);

}  // namespace
}  // namespace sfumato::hostile
