// Layers, groups, instances, blend modes and local curves: too many, too deep, too large.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string stroke(const std::string& attributes) {
  return svg("<path d='M9 9h80' sf:left='red' " + attributes + "/>");
}

void add_counts(Family& family) {
  family.add("layers_4097", kLimit, "more than the limit of 4096 layers",
             [] { return svg(repeated("<g sf:diffuse='true'/>", 4097)); });
  family.add("layers_100000", kLimit, "more than the limit of 4096 layers",
             [] { return svg(repeated(kLayer, 100'000)); });
  family.add("layers_256", kDone, "", [] { return svg(repeated(kLayer, 256)); });
  family.add("layers_empty_4096", kDone, "the layer has no curves",
             [] { return svg(repeated("<g sf:diffuse='true'/>", 4096)); });
  family.add("layers_in_defs_100000", kDone, "is drawn nowhere",
             [] { return svg("<defs>" + repeated(kLayer, 100'000) + "</defs>" + kLayer); });
  family.add("instances_300000", kLimit, "more than the limit of 200000", [] {
    return svg("<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
               repeated("<use href='#a'/>", 300'000));
  });
  family.add("instances_1000", kDone, "", [] {
    return svg("<defs><g id='a' sf:diffuse='true'><path d='M9 9h9' sf:left='red'/></g></defs>" +
               numbered("<use href='#a' x='", 1000, "'/>"));
  });
  family.add("curves_300000", kLimit, "more than the limit of 200000 curves",
             [] { return layer(repeated("<path d='M9 9h9' sf:left='red'/>", 300'000)); });
  family.add("local_curves_300000", kLimit, "more than the limit of 200000",
             [] { return svg(repeated(kStroke, 300'000)); });
  family.add("local_curves_5000", kDone, "", [] { return svg(repeated(kStroke, 5000)); });
  family.add("groups_nested_16", kDone, "", [] {
    return svg(repeated("<g opacity='.9'>", 16) + kStroke + kStroke + repeated("</g>", 16));
  });
  family.add("groups_nested_17", kLimit, "more than the limit of 16 groups within each other", [] {
    return svg(repeated("<g opacity='.9'>", 17) + kStroke + kStroke + repeated("</g>", 17));
  });
  family.add("groups_nested_200", kLimit, "more than the limit of 16 groups within each other", [] {
    return svg(repeated("<g style='isolation:isolate'>", 200) + kStroke + kStroke +
               repeated("</g>", 200));
  });
  family.add("groups_of_nothing_100000", kDone, "",
             [] { return svg(repeated("<g opacity='.5'/>", 100'000) + kLayer); });
  family.add("groups_of_one_3000", kDone, "",
             [] { return svg(repeated("<g opacity='.9'>" + kStroke + kStroke + "</g>", 3000)); });
  family
      .add("groups_300000", kLimit, "memory limit of 200 MiB",
           [] { return svg(repeated("<g opacity='.9'>" + kStroke + kStroke + "</g>", 300'000)); })
      .also({"--max-memory", "200"});
}

void add_blending(Family& family) {
  for (const char* mode : {"multiply", "screen", "overlay", "darken", "lighten", "color-dodge",
                           "color-burn", "hard-light", "soft-light", "difference", "exclusion",
                           "hue", "saturation", "color", "luminosity"}) {
    family.add(std::string("every_layer_") + mode, kDone, "", [mode] {
      const std::string black = "<g sf:diffuse='true' style='mix-blend-mode:" + std::string(mode) +
                                "'><path d='M9 9h80' sf:left='#000' sf:right='#fff' "
                                "sf:opacity='0,1'/></g>";
      return svg(repeated(black, 20));
    });
  }
  family.add("opacity_of_0_everywhere", kDone, "", [] {
    return svg(
        repeated("<g opacity='0' style='mix-blend-mode:hue'>" + kLayer + kStroke + "</g>", 50));
  });
  family.add("opacity_of_1e-320", kDone, "",
             svg("<g opacity='1e-320'>" + kLayer + kStroke + "</g>"));
}

void add_layer_strokes(Family& family) {
  family.add("radius_of_0", kBadInput, "is nowhere above 0", stroke("sf:radius='0'"));
  family.add("radius_tiny", kDone, "", stroke("sf:radius='1e-30'"));
  family.add("radius_vanishing", kBadInput, "is nowhere above 0", stroke("sf:radius='1e-320'"));
  family.add("radius_huge", kDone, "", stroke("sf:radius='1e7'"));
  family.add("radius_that_jumps", kDone, "",
             [] { return stroke("sf:radius='0" + repeated(",20,0", 1000) + "'"); });
  family.add("alpha_huge", kDone, "", stroke("sf:radius='3' sf:alpha='1e7'"));
  family.add("alpha_beyond", kBadInput, "sf:alpha of <path>",
             stroke("sf:radius='3' sf:alpha='1e8'"));
  family.add("alpha_negative", kBadInput, "sf:alpha of <path>",
             stroke("sf:radius='3' sf:alpha='-1'"));
  family.add("alpha_of_0", kDone, "", stroke("sf:radius='3' sf:alpha='0'"));
  family.add("no_colour", kBadInput, "the local curve has no colour",
             svg("<path d='M9 9h9' sf:radius='1'/>"));
  family.add("barrier", kBadInput, "sf:left of <path>",
             svg("<path d='M9 9h9' sf:left='none' sf:radius='1'/>"));
  family.add("weight", kBadInput, "sf:weight on <path> means nothing",
             stroke("sf:radius='1' sf:weight='2'"));
  family.add("cusp", kDone, "",
             svg("<path d='M9 25C99 25 9 25 90 25' sf:left='red' sf:radius='9'/>"));
  family.add("of_no_length", kDone, "has a part of no length",
             svg("<path d='M9 25h0' sf:left='red' sf:radius='9'/>"));
  family.add("far_away", kDone, "",
             svg("<path d='M9999999 25h-1' sf:left='red' sf:radius='9999999'/>"));
  family.add("scribble_of_10000_pieces", kDone, "", [] {
    return svg("<path d='M0 0" + repeated("c90 50 -90 50 50 9c-90 -50 90 -50 -50 -9", 5000) +
               "' sf:left='red' sf:radius='.1'/>");
  });
  family.add("large_over_large_400", kDone, "", [] {
    return svg(repeated("<path d='M0 25h99' sf:left='red' sf:alpha='.1' sf:radius='99'/>", 400));
  });
}

void add_layers_cases(Family& family) {
  add_counts(family);
  add_blending(family);
  add_layer_strokes(family);
}

const Register kLayers("layers", add_layers_cases);

}  // namespace
}  // namespace sfumato::hostile
