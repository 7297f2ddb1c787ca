// Orzan's XML.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string points(std::size_t count) {
  return "<curve><control_points_set>" + numbered("<control_point x='9' y='", count, "'/>") +
         "</control_points_set></curve>";
}

std::string colors(const std::string& attributes) {
  return orzan_curve("<left_colors_set><left_color " + attributes + "/></left_colors_set>");
}

void add_structure(Family& family) {
  family.add("no_curves", kDone, "the document has no curves", orzan(""));
  family.add("no_canvas", kBadInput, "has no attribute image_width", "<curve_set/>");
  for (const auto& [name, width] : {std::pair("zero", "0"),
                                    {"negative", "-9"},
                                    {"nan", "nan"},
                                    {"huge", "1e300"},
                                    {"word", "a"},
                                    {"empty", ""}}) {
    family.add(std::string("canvas_") + name, kBadInput, "in.svg:1:1",
               "<curve_set image_width='" + std::string(width) + "' image_height='9'/>");
  }
  family.add("canvas_of_a_gigapixel", kLimit, "the limit is 16384 pixels on a side",
             "<curve_set image_width='32000' image_height='32000'/>");
  family.add("canvas_of_a_hair", kDone, "", "<curve_set image_width='1e-9' image_height='1e-9'/>")
      .message = "the document has no curves";
  family
      .add("counters_that_lie", kDone, "",
           orzan(orzan_curve(colors("R='1' G='2' B='3' globalID='0'")), "nb_curves='4294967295'"))
      .message = "is not read";
  for (const std::size_t count : {0, 1, 3, 5, 6}) {
    family.add("points_" + std::to_string(count), kBadInput,
               "the curve has " + std::to_string(count) + " control points", orzan(points(count)));
  }
  family.add("points_a_million", kDone, "", [] { return orzan(points(300'001)); })
      .run({"info", "in.svg"});
  family
      .add("points_5_million", kLimit, "more than the limit of 67108864 bytes",
           [] { return orzan(repeated(points(100'000), 41)); })
      .message = "more than the limit of 67108864 bytes";
  family.add("curves_a_million", kLimit, "more than the limit of 200000 curves",
             [] { return orzan(repeated("<curve/>", kMillion)); });
  family.add("curves_100000", kDone, "", [] { return orzan(repeated(orzan_curve(), 20'000)); })
      .run({"info", "in.svg"});
  family.add("sets_in_sets", kLimit, "more than the limit of 256 elements within each other",
             [] { return orzan(repeated("<curve_set>", 999) + repeated("</curve_set>", 999)); });
  family
      .add("sets_100000", kDone, "",
           [] {
             return "<scene image_width='9' image_height='9'>" + repeated("<curve_set/>", 100'000) +
                    "</scene>";
           })
      .message = "the document has no curves";
  family.add("unknown_elements_of_100000_names", kDone, "more of other kinds",
             [] { return orzan(orzan_curve(numbered("<e", 100'000, "/>"))); });
  family.add("several_point_sets", kDone, "",
             [] { return orzan(orzan_curve(repeated("<control_points_set/>", 100'000))); });
  family.add("several_colour_sets", kDone, "", [] {
    return orzan(
        orzan_curve(repeated("<left_colors_set><left_color R='1' G='1' B='1' "
                             "globalID='0'/></left_colors_set>",
                             9'999)));
  });
}

void add_orzan_values(Family& family) {
  for (const auto& [name, attributes] : {std::pair("no_id", "R='1' G='1' B='1'"),
                                         {"no_red", "globalID='0' R='1' G='1'"},
                                         {"no_blue", "globalID='0' B='1' G='1'"},
                                         {"red_nan", "globalID='0' B='nan' G='1' R='1'"},
                                         {"id_nan", "globalID='nan' R='1' G='1' B='1'"},
                                         {"id_word", "globalID='a' R='1' G='1' B='1'"},
                                         {"id_beyond", "globalID='1e999' R='1' G='1' B='1'"},
                                         {"empty", "globalID='' R='' G='' B=''"}}) {
    family
        .add(std::string("colour_") + name, kBadInput, "of <left_color>", orzan(colors(attributes)))
        .message = "<left_color>";
  }
  family.add("colour_clamped", kDone, "are clamped",
             orzan(colors("globalID='0' R='-1e300' G='1e300' B='999'")));
  family.add("id_huge", kDone, "", orzan(colors("globalID='1e300' R='1' G='1' B='1'")));
  family.add("id_negative", kDone, "", orzan(colors("globalID='-1e300' R='1' G='1' B='1'")));
  family.add("stops_200000", kLimit, "more than the limit of 10000 stops in one list", [] {
    return orzan(orzan_curve("<left_colors_set>" +
                             repeated("<left_color globalID='0' R='1' G='1' B='1'/>", 200'000) +
                             "</left_colors_set>"));
  });
  family.add("stops_in_100000_sets", kLimit, "more than the limit of 10000 stops in one list", [] {
    return orzan(
        orzan_curve(repeated("<left_colors_set><left_color globalID='0' R='1' G='1' "
                             "B='1'/></left_colors_set>",
                             100'000)));
  });
  family.add("blurs_200000", kLimit, "stops in one list", [] {
    return orzan(orzan_curve("<blur_points_set>" +
                             repeated("<best_scale globalID='0' value='1'/>", 200'000) +
                             "</blur_points_set>"));
  });
  family.add("blur_negative", kDone, "below 0 is read as 0",
             orzan(orzan_curve("<blur_points_set><best_scale globalID='0' value='-1'/>"
                               "</blur_points_set>")));
  family.add("blur_huge", kDone, "",
             orzan(orzan_curve("<blur_points_set><best_scale globalID='0' value='9999999'/>"
                               "</blur_points_set>")));
  family.add("weights_a_million", kDone, "", [] {
    return orzan(
        orzan_curve("<weight_set>" + repeated("<weight w='2'/>", 300'000) + "</weight_set>"));
  });
  family.add("weights_that_vary", kDone, "is ignored: 1 is used",
             orzan(orzan_curve("<weight_set><weight w='2'/><weight w='3'/></weight_set>")));
  family.add("boundary_unknown", kDone, "",
             orzan(orzan_curve("<left_colors_set boundary='Robin'/>")));
  family.add("barriers_on_both_sides", kDone, "",
             orzan(orzan_curve("<left_colors_set boundary='Neumann'/><right_colors_set "
                               "boundary='Neumann'/>")));
  family.add("points_far_apart", kDone, "", [] {
    return orzan(
        "<curve><control_points_set><control_point x='-9999999' y='-9999999'/>"
        "<control_point x='9999999' y='9999999'/><control_point x='-9999999' y='9999999'/>"
        "<control_point x='9999999' y='-9999999'/></control_points_set></curve>");
  });
  family.add("points_equal", kDone, "", [] {
    return orzan("<curve><control_points_set>" + repeated("<control_point x='9' y='9'/>", 4) +
                 "</control_points_set></curve>");
  });
  family.add("point_beyond", kBadInput, "use a magnitude of at most 10000000",
             orzan("<curve><control_points_set>" + repeated("<control_point x='1e8' y='9'/>", 4) +
                   "</control_points_set></curve>"));
}

void add_orzan_cases(Family& family) {
  add_structure(family);
  add_orzan_values(family);
}

const Register kOrzan("orzan", add_orzan_cases);

}  // namespace
}  // namespace sfumato::hostile
