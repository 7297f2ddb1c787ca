// An empty picture has a warning with the reason.
#include <gtest/gtest.h>

#include "formats/svg/svg_support.hpp"

namespace sfumato::test {
namespace {

/// Returns the warnings of a text, one after the other.
std::string told(const std::string& text) {
  std::string all;
  for (const std::string& warning : warnings_of(text)) all += warning + "\n";
  return all;
}

void expect_told(const std::string& text, const std::string& what) {
  EXPECT_NE(told(text).find(what), std::string::npos) << told(text) << "\nexpected " << what;
}

TEST(SvgEmpty, drawing_without_anything_of_sfumato_is_told_what_it_needs) {
  expect_told("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><path d='M0 0h9'/></svg>",
              "the picture is empty; it contains no curves of Sfumato; add curves with sf:left");
}

TEST(SvgEmpty, prefix_that_is_bound_elsewhere_is_named_with_the_right_address) {
  expect_told(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='https://sfumato.org/ns' "
      "viewBox='0 0 9 9'><g sf:diffuse='true'><path d='M0 0h9' sf:left='red'/></g></svg>",
      "the prefix sf is bound to \"https://sfumato.org/ns\"; use xmlns:sf=\"urn:sfumato:1\"");
}

TEST(SvgEmpty, attribute_without_prefix_or_in_a_style_is_named) {
  expect_told(svg("<g diffuse='true'><path d='M0 0h9' left='red'/></g>"),
              "diffuse of <g> has no prefix; use sf:diffuse");
  expect_told(svg_layer("<path d='M0 0h9' left='red'/>"),
              "<path> in a layer bears nothing and draws nothing: left of <path> has no prefix; "
              "use sf:left");
  expect_told(svg_layer("<path d='M0 0h9' style='sf:left:red'/>"),
              "sf:left of <path> is in style; write it as an attribute: sf:left=\"…\"");
}

TEST(SvgEmpty, plain_stroke_in_a_layer_is_told) {
  expect_told(svg_layer("<path d='M0 0h9' stroke='red'/><path d='M0 0h9' sf:left='red'/>"),
              "a.svg:3:1: <path> in a layer bears nothing and draws nothing: stroke and fill are "
              "not read there; use sf:left, sf:right or both");
}

TEST(SvgEmpty, picture_with_a_colour_says_nothing) {
  EXPECT_EQ(told(svg_layer("<path d='M0 0h9' sf:left='red'/>")), "");
}

TEST(SvgStops, radii_are_lengths) {
  const auto blur = [](const std::string& list) {
    return curve_of("<path d='M0 0h9' sf:left='red' sf:blur='" + list + "'/>").left.blur_radius;
  };
  EXPECT_EQ(blur("3px"), blur("3"));
  EXPECT_EQ(blur("1in 50%, 0"), blur("96 50%, 0"));
  EXPECT_EQ(
      status_of(svg_layer("<path d='M0 0h9' sf:left='red' sf:blur='3em'/>")).message,
      "sf:blur of <path>: \"3em\" is not a valid blur radius; use a number from 0 to 10000000, "
      "perhaps with px, pt, pc, mm, cm or in");
  EXPECT_FALSE(status_of(svg_layer("<path d='M0 0h9' sf:left='red' sf:blur='5%'/>")).ok());
  EXPECT_FALSE(status_of(svg_layer("<path d='M0 0h9' sf:left='red' sf:blur='-1px'/>")).ok());
}

TEST(SvgXml, syntax_errors_name_the_element) {
  const auto ends_with = [](const std::string& text, const std::string& end) {
    const std::string message = status_of(text).message;
    EXPECT_TRUE(message.ends_with(end)) << message;
  };
  ends_with("<svg>\n<g>\n<a/><b></b>\n</svg>", ": <g> of line 2 is still open at </svg>");
  ends_with("<svg>\n</g></svg>", ": <svg> of line 1 is still open at </g>");
  ends_with("<svg>\n<g></g>\n<path>", ": <path> of line 3 is not closed");
  ends_with("<svg>\n<g></g>\n", ": <svg> of line 1 is not closed");
  ends_with("<svg>\n<path d=3/></svg>", "element attribute of <path>");
  ends_with("<svg>\n<path d='3'id='4'/></svg>", "element attribute of <path>");
  ends_with("<svg>\n<path d='3' </svg>", "start element tag of <path>");
  ends_with("<svg>\n<g></g x='3'></svg>", "end element tag of </g>");
}

}  // namespace
}  // namespace sfumato::test
