// Path data and shapes.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

void add_syntax(Family& family) {
  for (const auto& [name, data] : {std::pair("no_move", "L1 1"),
                                   {"number_first", "1 1"},
                                   {"comma_first", ",M0 0"},
                                   {"unknown_command", "M0 0 X1"},
                                   {"lone_command", "M0 0 L"},
                                   {"half_a_point", "M0 0 L1"},
                                   {"half_a_cubic", "M0 0 C1 1 2 2"},
                                   {"two_commas", "M0 0,,1 1"},
                                   {"bad_flag", "M0 0A1 1 0 2 0 1 1"},
                                   {"half_an_arc", "M0 0A1 1 0 1"},
                                   {"numbers_behind_z", "M0 0 h9 Z 1 1"},
                                   {"hash", "M0 0 #"},
                                   {"quote", "M0 0\""},
                                   {"entity", "M0 0&lt;"},
                                   {"none_and_more", "none 1"},
                                   {"percent", "M0 0 L1% 1%"},
                                   {"units", "M0 0 L1px 1px"},
                                   {"nan", "M nan nan"},
                                   {"exponent_alone", "M0 0 L1e 1"},
                                   {"two_points", "M0 0 L1..2 1"}}) {
    family.add(name, kBadInput, "d of <path>", path(data));
  }
  family.add("empty", kDone, "has a part of no length, or draws nothing", path(""));
  family.add("none", kDone, "has a part of no length, or draws nothing", path("none"));
  family.add("only_moves", kDone, "has a part of no length", path("M1 1M2 2m3 3"));
  family.add("only_a_close", kBadInput, "d of <path>", path("z"));
  family.add("closes_a_million", kDone, "has a part of no length",
             [] { return path("M0 0" + repeated("z", kMillion)); });
  family.add("moves_a_million", kDone, "has a part of no length",
             [] { return path(repeated("M0 0", kMillion)); });
  family.add("commas_a_million", kBadInput, "d of <path>",
             [] { return path("M0 0" + repeated(",", kMillion)); });
  family.add("signs_a_million", kBadInput, "d of <path>",
             [] { return path("M0 0" + repeated("-", kMillion)); });
  family.add("points_a_million", kBadInput, "d of <path>",
             [] { return path("M0 0 L" + repeated(".", kMillion)); });
  family.add("letters_a_million", kBadInput, "d of <path>",
             [] { return path(repeated("x", kMillion)); });
  family.add("blanks_a_million", kDone, "has a part of no length",
             [] { return path(repeated(" ", kMillion)); });
  family.add("numbers_run_together", kDone, "", path("M.5.5.6.6-.5-.5+1+1e1 30 30"));
  family.add("exponents_run_together", kBadInput, "d of <path>", path("M0 0L1e1e1 30"));
  family.add("flags_run_together", kDone, "", path("M9 9a9 9 0 0130 9"));
}

void add_shapes(Family& family) {
  const auto shape = [](const std::string& element) {
    return layer("<" + element + " sf:left='red'/>");
  };
  family.add("lines_5_million", kLimit, "more than the limit of 4000000 control points",
             [] { return path("M0 0" + repeated("h1", 5'000'000)); });
  family.add("arcs_a_million", kLimit, "more than the limit of 4000000 control points",
             [] { return path("M0 0" + repeated("a9 9 0 119 9", kMillion)); });
  family.add("subpaths_a_million", kLimit, "more than the limit of 200000 curves",
             [] { return path(repeated("M0 0h9", kMillion)); });
  family.add("relative_lines_that_run_away", kBadInput, "reaches farther than 10000000",
             [] { return path("M0 0" + repeated("h9999999", 1000)); });
  family.add("arc_of_no_radius", kDone, "", path("M9 9A0 0 0 0 0 30 30"));
  family.add("arc_to_itself", kDone, "", path("M9 9A5 5 0 1 1 9 9h9"));
  family.add("arc_of_a_tiny_radius", kBadInput, "reaches farther than 10000000",
             path("M9 9A1e-300 1e-300 0 1 1 30 30"));
  family.add("arc_of_a_huge_radius", kDone, "", path("M9 9A1e7 1e7 0 0 1 30 30"));
  family.add("arc_of_a_huge_radius_the_long_way", kDone, "", path("M9 9A1e6 1e6 0 1 1 30 30"))
      .message = "";
  family.add("arc_of_a_flat_ellipse", kBadInput, "reaches farther than 10000000",
             path("M9 9A1e6 1e-6 30 1 1 30 30"));
  family.add("arc_turned_1e7_degrees", kDone, "", path("M9 9A20 9 9999999 1 1 30 30"));
  family.add("arc_to_a_neighbour", kDone, "", path("M9 9A9 9 0 1 1 9.0000000001 9"));
  family.add("circle_huge", kDone, "", shape("circle r='9999999'"));
  family.add("circle_tiny", kDone, "has a part of no length",
             shape("circle cx='50' cy='25' r='1e-300'"));
  family.add("circle_of_nothing", kDone, "draws nothing", shape("circle r='0'"));
  family.add("circle_negative", kBadInput, "r of <circle> is negative", shape("circle r='-1'"));
  family.add("ellipse_flat", kDone, "", shape("ellipse cx='50' cy='25' rx='40' ry='1e-9'"));
  family.add("rect_flat", kDone, "draws nothing", shape("rect width='9'"));
  family.add("rect_negative", kBadInput, "is negative", shape("rect width='-9' height='9'"));
  family.add("rect_of_huge_corners", kDone, "", shape("rect width='9' height='9' rx='9999999'"));
  family.add("rect_beyond", kBadInput, "reaches farther",
             shape("rect x='9999999' width='9999999' height='9'"));
  family.add("polygon_of_one_point", kDone, "draws nothing", shape("polygon points='1 1'"));
  family.add("polygon_of_an_odd_number", kBadInput, "points of <polygon>",
             shape("polygon points='1 1 2'"));
  family.add("polygon_of_a_million_equal_points", kDone, "has a part of no length",
             [shape] { return shape("polygon points='" + repeated("1 1 ", kMillion) + "'"); });
  family.add("polygon_of_2_million_points", kLimit, "more than the limit of 4000000 control points",
             [shape] { return shape("polygon points='" + repeated("1 1 2 2 ", kMillion) + "'"); });
  family.add("line_of_nothing", kDone, "draws nothing", shape("line"));
  family.add("line_of_words", kBadInput, "x1 of <line>", shape("line x1='a'"));
  for (const char* unit : {"em", "ex", "rem", "vw", "q"}) {
    family.add(std::string("unit_") + unit, kDone, "",
               shape("circle r='1" + std::string(unit) + "'"));
  }
  for (const char* unit : {"%%", "px px", "pxx", "furlong"}) {
    std::string name = std::string("unit_") + unit;
    for (char& c : name) c = c == '%' ? 'p' : c == ' ' ? '_' : c;
    family.add(name, kBadInput, "r of <circle>", shape("circle r='1" + std::string(unit) + "'"));
  }
  family.add("unit_of_huge_inches", kBadInput, "r of <circle>", shape("circle r='9999999in'"));
  family.add("percent_of_1e7", kBadInput, "r of <circle>", shape("circle r='9999999999%'"));
}

void add_paths_cases(Family& family) {
  add_syntax(family);
  add_shapes(family);
}

const Register kPaths("paths", add_paths_cases);

}  // namespace
}  // namespace sfumato::hostile
