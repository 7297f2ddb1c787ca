// Stop lists and colours.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string colored(const std::string& list) {
  return curve("sf:left=\"" + list + "\"");
}

void add_lists(Family& family) {
  for (const auto& [name, list] : {std::pair("empty", ""),
                                   {"blanks", "   "},
                                   {"comma", ","},
                                   {"comma_last", "red,"},
                                   {"comma_first", ",red"},
                                   {"two_commas", "red,,blue"},
                                   {"no_comma", "red blue"},
                                   {"offset_first", "50% red"},
                                   {"offset_alone", "50%"},
                                   {"two_offsets", "red 1% 2%"},
                                   {"offset_nan", "red nan%"},
                                   {"offset_negative", "red -1%"},
                                   {"offset_beyond", "red 100.1%"},
                                   {"offset_huge", "red 1e308%"},
                                   {"offset_without_unit", "red .5"},
                                   {"offset_at", "red @"},
                                   {"offset_at_negative", "red @-1"},
                                   {"offset_at_huge", "red @1e300"},
                                   {"offset_at_nan", "red @nan"},
                                   {"url_in_a_list", "red, url(#a)"},
                                   {"none_in_a_list", "red, none"},
                                   {"url_with_offset", "url(#a) 5%"},
                                   {"semicolon", "red; blue"},
                                   {"brackets", "((((("},
                                   {"quotes", "'red'"},
                                   {"bytes", "\xff\xfe"}}) {
    family.add(name, kBadInput, "sf:left", colored(list));
  }
  family.add("a_million_colours", kLimit, "more than the limit of 10000 stops in one list",
             [] { return colored("red" + repeated(",blue", kMillion)); });
  family.add("a_million_commas", kLimit, "more than the limit of 10000 stops in one list",
             [] { return colored(repeated(",", kMillion)); });
  family.add("a_million_brackets", kBadInput, "sf:left",
             [] { return colored(repeated("(", kMillion)); });
  family.add("a_million_quotes", kBadInput, "sf:left",
             [] { return colored(repeated("'", kMillion)); });
  family.add("a_million_blanks", kDone, "",
             [] { return colored(repeated(" ", kMillion) + "red"); });
  family.add("a_word_of_a_megabyte", kBadInput, "sf:left",
             [] { return colored(repeated("a", kMillion)); });
  family
      .add("as_many_as_allowed", kDone, "",
           [] { return colored("red" + repeated(",blue,lime", 4'999) + ",red"); })
      .run({"info", "in.svg"});
  family.add("colours_that_jump_100_times", kDone, "",
             [] { return colored("red" + repeated(",blue,lime", 50)); });
  family.add("as_many_equal_offsets_as_allowed", kDone, "",
             [] { return colored("red 50%" + repeated(",blue 50%", 9'999)); });
  family.add("as_many_backwards_as_allowed", kDone, "", [] {
    std::string list = "red";
    for (int i = 9'998; i > 0; --i) list += ",blue " + std::to_string(i * 0.01) + "%";
    return colored(list);
  });
  family.add("as_many_missing_offsets_as_allowed", kDone, "",
             [] { return colored("red 0%" + repeated(",blue", 9'997) + ",red 1e-300%"); });
  family.add("lists_times_subpaths", kLimit, "more than the limit of 8000000 stops", [] {
    return layer("<path d='" + repeated("M0 0h9", 10'000) + "' sf:left-blur='1" +
                 repeated(",2", 9'999) + "' sf:left='red'/>");
  });
  family.add("blurs_that_jump", kDone, "",
             [] { return curve("sf:left='red' sf:blur='0" + repeated(",9,0", 20) + "'"); });
  family.add("opacities_that_jump", kDone, "",
             [] { return curve("sf:left='red' sf:opacity='0" + repeated(",1,0", 20) + "'"); });
  family.add("opacity_above_1", kBadInput, "sf:opacity of <path>",
             curve("sf:left='red' sf:opacity='1.0001'"));
  family.add("blur_negative", kBadInput, "sf:blur of <path>", curve("sf:left='red' sf:blur='-1'"));
  family.add("weight_as_a_list", kBadInput, "sf:weight of <path>",
             curve("sf:left='red' sf:weight='1,2'"));
  family.add("weight_of_0", kBadInput, "sf:weight of <path>", curve("sf:left='red' sf:weight='0'"));
  family.add("beyond_the_end", kDone, "lies beyond the last segment",
             colored("red, blue @9999999"));
}

void add_colors(Family& family) {
  for (const auto& [name, text] : {std::pair("hash", "#"),
                                   {"two_digits", "#12"},
                                   {"five_digits", "#12345"},
                                   {"no_digits", "#ggg"},
                                   {"nine_digits", "#123456789"},
                                   {"misspelt", "rde"},
                                   {"current", "currentColor"},
                                   {"inherit", "inherit"},
                                   {"two_arguments", "rgb(1,2)"},
                                   {"five_arguments", "rgb(1,2,3,4,5)"},
                                   {"nan_arguments", "rgb(nan,nan,nan)"},
                                   {"nested", "rgb(rgb(1,2,3),2,3)"},
                                   {"variable", "var(--a)"},
                                   {"calculated", "rgb(calc(1),2,3)"},
                                   {"icc", "red icc-color(a)"},
                                   {"lab_with_commas", "lab(1%,2,3)"},
                                   {"space", "color(p3 1 2 3)"},
                                   {"relative", "oklch(from red l c h)"},
                                   {"transparent", "transparent"},
                                   {"translucent", "#ff000080"},
                                   {"rgba", "rgba(1,2,3,.5)"},
                                   {"mixed", "color-mix(in lab,red,blue)"},
                                   {"hex_of_unicode", "#１２３"}}) {
    family.add(std::string("colour_") + name, kBadInput, "sf:left of <path>", colored(text));
  }
  family.add("colour_clamped", kDone, "", colored("rgb(-9999999,99999999,300)"));
  family.add("colour_huge", kDone, "", colored("rgb(1e300,-1e300,1e-300)"));
  family.add("colour_beyond_doubles", kBadInput, "sf:left of <path>", colored("rgb(1e400,0,0)"));
  family.add("colour_outside_srgb_huge", kDone, "lies outside sRGB",
             colored("color(xyz 1e300 -1e300 1e300)"));
  family.add("colour_huge_in_space", kBadInput, "sf:left of <path>",
             colored("color(srgb 1e400 0 0)"));
  family
      .add("as_many_outside_srgb_as_allowed", kDone, "lies outside sRGB",
           [] { return colored("red" + repeated(",lab(9 999 99)", 9'999)); })
      .run({"info", "in.svg"});
  family.add("hue_huge", kDone, "", colored("hsl(1e15,50%,50%)"));
  family.add("hue_beyond", kDone, "", colored("hsl(1e300,50%,50%)"));
  family.add("hue_negative", kDone, "", colored("hsl(-1e300deg 50% 50%)"));
  family.add("whiteness_and_blackness_beyond", kDone, "", colored("hwb(1 900% 900%)"));
  family.add("colour_of_a_million_blanks", kDone, "",
             [] { return colored("rgb(1," + repeated(" ", kMillion) + "2,3)"); });
  family.add("colour_of_a_million_arguments", kLimit, "stops in one list",
             [] { return colored("rgb(" + repeated("1,", kMillion) + "1)"); });
  family.add("colour_of_a_million_digits", kBadInput, "sf:left of <path>",
             [] { return colored("#" + repeated("1", kMillion)); });
}

void add_stops_cases(Family& family) {
  add_lists(family);
  add_colors(family);
}

const Register kStops("stops", add_stops_cases);

}  // namespace
}  // namespace sfumato::hostile
