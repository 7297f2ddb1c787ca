// Invalid, too large, too small or endless numbers in every place for a number.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

struct Place {
  const char* name;
  std::string (*document)(const std::string& number);
  const char* message;  ///< part of the message
};

const Place kPlaces[] = {
    {"path", [](const std::string& n) { return path("M0 0 L" + n + " 9"); }, "d of <path>"},
    {"points", [](const std::string& n) { return layer("<polyline points='0 0 9 " + n + "'/>"); },
     "points of <polyline>"},
    {"radius_of_a_circle",
     [](const std::string& n) { return layer("<circle r='" + n + "' sf:left='red'/>"); },
     "r of <circle>"},
    {"weight", [](const std::string& n) { return curve("sf:left='red' sf:weight='" + n + "'"); },
     "sf:weight of <path>"},
    {"blur", [](const std::string& n) { return curve("sf:left='red' sf:blur='1," + n + "'"); },
     "sf:blur of <path>"},
    {"offset", [](const std::string& n) { return curve("sf:left='red,blue @" + n + "'"); },
     "sf:left of <path>"},
    {"opacity_of_a_curve",
     [](const std::string& n) { return curve("sf:left='red' sf:opacity='" + n + "'"); },
     "sf:opacity of <path>"},
    {"radius_of_influence",
     [](const std::string& n) {
       return svg("<path d='M9 9h9' sf:left='red' sf:radius='" + n + "'/>");
     },
     "sf:radius of <path>"},
    {"view_box",
     [](const std::string& n) {
       return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 " + n + "'/>";
     },
     "viewBox of <svg>"},
    {"translate",
     [](const std::string& n) { return svg("<g transform='translate(" + n + ")'/>" + kLayer); },
     "transform of <g>"},
    {"gradient",
     [](const std::string& n) {
       return painted("<linearGradient id='p' gradientUnits='userSpaceOnUse' x2='" + n +
                      "'><stop/></linearGradient>");
     },
     "x2 of <linearGradient>"},
    {"orzan",
     [](const std::string& n) {
       return orzan(orzan_curve("<weight_set><weight w='" + n + "'/></weight_set>"));
     },
     "w of <weight>"},
};

/// Invalid in every place.
const struct {
  const char* name;
  const char* text;
} kWords[] = {
    {"nan", "nan"},
    {"minus_nan", "-nan"},
    {"infinity", "inf"},
    {"infinity_long", "-Infinity"},
    {"hex", "0x10"},
    {"hex_float", "0x1p3"},
    {"two_signs", "--1"},
    {"signs", "+-1"},
    {"sign", "-"},
    {"point", "."},
    {"exponent", "e5"},
    {"words", "one"},
    {"arabic", "١٢"},
    {"full_width", "９"},
    {"minus_of_unicode", "−1"},
};

/// Decimals beyond every limit.
const struct {
  const char* name;
  std::string text;
} kHuge[] = {
    {"1e308", "1e308"},
    {"1e309", "1e309"},
    {"minus_1e308", "-1e308"},
    {"1e99999999999", "1e99999999999"},
    {"digits_400", repeated("9", 400)},
    {"digits_10000", repeated("9", 10'000)},
    {"just_beyond", "10000000.01"},
};

void add_small(Family& family) {
  const std::string small[][2] = {
      {"1e-308", "1e-308"},
      {"1e-320", "1e-320"},
      {"1e-400", "1e-400"},
      {"1e-99999999999", "1e-99999999999"},
      {"digits_10000", "0." + repeated("0", 10'000) + "1"},
      {"zeros_10000", repeated("0", 10'000) + "1"},
      {"fraction_10000", "1." + repeated("3", 10'000)},
  };
  for (const auto& [name, number] : small) {
    family.add("small_" + name + "_in_a_path", kDone, "", path("M0 0 L" + number + " 9"));
    family.add("small_" + name + "_as_blur", kDone, "",
               curve("sf:left='red' sf:blur='" + number + "'"));
    family.add("small_" + name + "_as_offset", kDone,
               name == "fraction_10000" ? "lies beyond the last segment" : "",
               curve("sf:left='red, blue @" + number + ", lime'"));
    family.add("small_" + name + "_as_opacity", kDone, "",
               svg("<g opacity='" + number + "'>" + kLayer + "</g>"));
  }
  family.add("minus_zero", kDone, "", path("M-0 -0L-0.0 9-0 9-0e9 3-.0-.0"));
  family.add("minus_zero_weight", kBadInput, "sf:weight of <path>",
             curve("sf:left='red' sf:weight='-0'"));
  family.add("minus_zero_opacity", kDone, "", curve("sf:left='red' sf:opacity='-0'"));
  family.add("minus_zero_offset", kDone, "", curve("sf:left='red -0%, blue'"));
  family.add("weight_1e-320", kDone, "", curve("sf:left='red' sf:weight='1e-320'"));
  family.add("weight_1e7", kDone, "", curve("sf:left='red' sf:weight='1e7'"));
  family.add("weights_far_apart", kDone, "",
             layer("<path d='M9 9h9' sf:left='red' sf:weight='1e-300'/><path d='M9 19h9' "
                   "sf:left='blue' sf:weight='1e7'/>"));
  family.add("blur_1e7", kDone, "", curve("sf:left='red' sf:right='blue' sf:blur='1e7'"));
  family.add("blur_of_a_million_digits", kBadInput, "sf:blur of <path>",
             [] { return curve("sf:left='red' sf:blur='" + repeated("9", kMillion) + "'"); });
  family.add("path_of_a_million_digits", kBadInput, "d of <path>",
             [] { return path("M0 0h" + repeated("9", kMillion)); });
  family.add("path_of_a_million_zeros", kDone, "",
             [] { return path("M0 0h" + repeated("0", kMillion) + "9"); });
  family.add("path_of_a_million_decimals", kDone, "",
             [] { return path("M0 0h9." + repeated("1", kMillion)); });
  family.add("exponent_of_a_million_digits", kBadInput, "d of <path>",
             [] { return path("M0 0h9e" + repeated("1", kMillion)); });
  family.add("exponent_of_a_million_digits_below", kDone, "",
             [] { return path("M0 0h9v9e-" + repeated("1", kMillion)); });
}

void add_numbers_cases(Family& family) {
  for (const Place& place : kPlaces) {
    for (const auto& [name, text] : kWords) {
      family.add(std::string(name) + "_as_" + place.name, kBadInput, place.message,
                 place.document(text));
    }
    for (const auto& [name, text] : kHuge) {
      // Offsets beyond the end and translations may have any size within a double.
      family.add(std::string(name) + "_as_" + place.name, kBadInput, place.message,
                 place.document(text));
    }
  }
  add_small(family);
}

const Register kNumbers("numbers", add_numbers_cases);

}  // namespace
}  // namespace sfumato::hostile
