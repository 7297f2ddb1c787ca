// Transforms that flatten, explode, do not parse, or come in thousands.
#include "hostile/case.hpp"
#include "hostile/documents.hpp"

namespace sfumato::hostile {
namespace {

std::string transformed(const std::string& transform) {
  return svg("<g transform='" + transform + "'>" + kLayer + "</g>");
}

std::string curve_transformed(const std::string& transform) {
  return layer("<path transform='" + transform + "' d='M9 9h80v30' sf:left='red' sf:blur='3'/>");
}

void add_transforms_cases(Family& family) {
  for (const auto& [name, text] : {std::pair("unknown", "perspective(1)"),
                                   {"misspelt", "rotat(1)"},
                                   {"no_bracket", "scale 1"},
                                   {"no_end", "scale(1"},
                                   {"no_arguments", "scale()"},
                                   {"too_many", "scale(1 2 3)"},
                                   {"seven", "matrix(1 2 3 4 5 6 7)"},
                                   {"two_for_rotate", "rotate(1 2)"},
                                   {"comma_first", "scale(,1)"},
                                   {"units", "translate(1px)"},
                                   {"nan", "scale(nan)"},
                                   {"huge", "scale(1e300)"},
                                   {"bytes", "\x80"},
                                   {"brackets", "((((("},
                                   {"nested", "scale(scale(1))"}}) {
    family.add(std::string("bad_") + name, kBadInput, "transform of <g>", transformed(text));
    family.add(std::string("bad_on_a_curve_") + name, kBadInput, "transform of <path>",
               curve_transformed(text));
  }
  family.add("flat", kDone, "is flattened to nothing", transformed("scale(0)"));
  family.add("flat_in_one_direction", kDone, "is flattened to nothing", transformed("scale(1 0)"));
  family.add("flat_curve", kDone, "is flattened to nothing",
             curve_transformed("matrix(1 1 1 1 0 0)"));
  family.add("nearly_flat", kLimit, "a transform or the viewport reaches too far",
             transformed("matrix(1 1 1 1.0000001 0 0)"));
  family.add("nearly_flat_curve", kDone, "", curve_transformed("matrix(1 1 1 1.0000001 0 0)"));
  family.add("skew_of_90_degrees", kBadInput, "transform", transformed("skewX(90)"));
  family.add("skew_of_89.9999999", kBadInput, "too large or too small",
             transformed("skewX(89.9999999)"));
  family.add("rotation_of_1e7_degrees", kDone, "", transformed("rotate(9999999.9)"));
  family.add("rotation_about_1e7", kDone, "", transformed("rotate(1 9999999 0)")).message = "";
  family.add("mirrored", kDone, "", curve_transformed("scale(-1 1) translate(-100)"));
  family.add("large", kDone, "", transformed("scale(1e6)"));
  family.add("large_curve", kBadInput, "reaches farther than 10000000",
             curve_transformed("scale(1e6)"));
  family.add("small", kLimit, "a transform or the viewport reaches too far",
             transformed("scale(1e-6)"));
  family.add("small_curve", kDone, "", curve_transformed("scale(1e-6)"));
  family.add("products_that_overflow", kBadInput, "the product is too large",
             transformed(repeated("scale(1e7)", 50)));
  family.add("products_that_vanish", kDone, "is flattened to nothing",
             transformed(repeated("scale(1e-7)", 60)));
  family.add("products_that_cancel", kDone, "",
             transformed(repeated("scale(1e7)", 40) + repeated("scale(1e-7)", 40)));
  family.add("nested_that_overflow", kBadInput, "too large or too small", [] {
    return svg(repeated("<g transform='scale(1000)'>", 200) + kLayer + repeated("</g>", 200));
  });
  family.add("nested_that_vanish", kBadInput, "too large or too small", [] {
    return svg(repeated("<g transform='scale(.001)'>", 200) + kLayer + repeated("</g>", 200));
  });
  family.add("a_million_functions", kDone, "",
             [] { return transformed(repeated("scale(1)", kMillion)); });
  family.add("a_million_rotations", kDone, "",
             [] { return transformed(repeated("rotate(360)", 500'000)); });
  family.add("a_million_commas", kBadInput, "transform of <g>",
             [] { return transformed("scale(1)" + repeated(",", kMillion)); });
  family.add("an_argument_list_of_a_million", kBadInput, "transform of <g>",
             [] { return transformed("matrix(" + repeated("1 ", kMillion) + ")"); });
  family.add("a_name_of_a_megabyte", kBadInput, "transform of <g>",
             [] { return transformed(repeated("a", kMillion)); });
  family.add(
      "of_a_gradient_flat", kBadInput, "cannot be inverted",
      painted("<linearGradient id='p' gradientTransform='scale(0)'><stop/></linearGradient>"));
  family.add("of_a_gradient_nearly_flat", kDone, "",
             painted("<linearGradient id='p' gradientTransform='scale(1e-6)'><stop/><stop "
                     "offset='1' stop-color='red'/></linearGradient>"));
  family.add("of_a_local_curve_small", kDone, "",
             svg("<g transform='scale(1e-6)'>" + kStroke + "</g>"));
  family.add("of_a_local_curve_large", kDone, "",
             svg("<g transform='scale(1e6)'>" + kStroke + "</g>"));
  family.add("of_a_local_curve_skewed", kDone, "",
             svg("<g transform='matrix(1 1 1 1.000001 0 0)'>" + kStroke + "</g>"));
}

const Register kTransforms("transforms", add_transforms_cases);

}  // namespace
}  // namespace sfumato::hostile
