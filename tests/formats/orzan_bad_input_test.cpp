// Invalid XML of Orzan: one clear message with its place.
#include <gtest/gtest.h>

#include <string>

#include "sfumato/base/limits.hpp"
#include "sfumato/formats/orzan/orzan.hpp"

namespace sfumato {
namespace {

const std::string kHead = "<curve_set image_width='30' image_height='20'>\n";

std::string points(int count, const std::string& first = "<control_point x='1' y='2'/>") {
  std::string xml = "<control_points_set>" + (count > 0 ? first : "");
  for (int i = 1; i < count; ++i) xml += "<control_point x='1' y='2'/>";
  return xml + "</control_points_set>";
}

std::string curve_with(const std::string& parts) {
  return kHead + " <curve>" + parts + "</curve>\n</curve_set>";
}

Status status_of(const std::string& xml, const Limits& limits = {}) {
  Context context{.limits = limits};
  const Status status = read_orzan(context, xml, "a.xml").status();
  EXPECT_EQ(context.budget.used(), 0u);
  return status;
}

struct BadInput {
  const char* name;
  std::string xml;
  const char* message;
};

class BadOrzan : public testing::TestWithParam<BadInput> {};

TEST_P(BadOrzan, is_refused_with_place_and_reason) {
  const Status status = status_of(GetParam().xml);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(to_string(status), GetParam().message);
}

const BadInput kBadInputs[] = {
    {"empty_file", "", "a.xml: the file is empty; use an SVG or Orzan XML file"},
    {"blank_file", " \n \n", "a.xml: no XML element found; use an SVG or Orzan XML file"},
    {"not_xml", "solid ascii\nvertex 1 2 3\n",
     "a.xml: no XML element found; use an SVG or Orzan XML file"},
    {"binary", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
     "a.xml: is a PNG picture; use a drawing (SVG or Orzan XML), or trace the picture to make one"},
    {"truncated_in_a_tag", kHead + " <curve><control_po",
     "a.xml:2:19: the XML is cut short: Error parsing start element tag of <control_po>"},
    {"truncated_in_an_attribute", kHead + " <curve nb='",
     "a.xml:2:12: the XML is cut short: Error parsing element attribute of <curve>"},
    {"truncated_between_tags", kHead + " <curve>\n",
     "a.xml:2:9: the XML is cut short: Start-end tags mismatch: <curve> of line 2 is not closed"},
    {"mismatched_tags", kHead + " <curve></carve>\n</curve_set>",
     "a.xml:2:11: not well-formed XML: Start-end tags mismatch: <curve> of line 2 is still open at "
     "</carve>"},
    {"other_document", "\n  <svg/>",
     "a.xml:2:3: the document is a <svg>; use <curve_set> or <scene>"},
    {"no_canvas", "<curve_set image_height='3'/>",
     "a.xml:1:1: <curve_set> has no attribute image_width"},
    {"flat_canvas", "<curve_set image_width='0' image_height='3'/>",
     "a.xml:1:1: the canvas has no area; use image_width and image_height above 0"},
    {"negative_canvas", "<curve_set image_width='3' image_height='-3'/>",
     "a.xml:1:1: the canvas has no area; use image_width and image_height above 0"},
    {"canvas_of_nan", "<curve_set image_width='nan' image_height='3'/>",
     "a.xml:1:1: image_width of <curve_set> is \"nan\"; use a finite number"},
    {"huge_canvas", "<curve_set image_width='1e300' image_height='3'/>",
     "a.xml:1:1: image_width of <curve_set> is 1e300; use a magnitude of at most 10000000"},
    {"no_control_points_set", curve_with(""),
     "a.xml:2:2: the curve has 0 control points; use 3n+1 of them (4, 7, 10, …)"},
    {"control_points_0", curve_with(points(0)),
     "a.xml:2:9: the curve has 0 control points; use 3n+1 of them (4, 7, 10, …)"},
    {"control_points_1", curve_with(points(1)),
     "a.xml:2:9: the curve has 1 control points; use 3n+1 of them (4, 7, 10, …)"},
    {"control_points_2", curve_with(points(2)),
     "a.xml:2:9: the curve has 2 control points; use 3n+1 of them (4, 7, 10, …)"},
    {"control_points_5", curve_with(points(5)),
     "a.xml:2:9: the curve has 5 control points; use 3n+1 of them (4, 7, 10, …)"},
    {"coordinate_nan", curve_with(points(4, "<control_point x='NaN' y='0'/>")),
     "a.xml:2:29: x of <control_point> is \"NaN\"; use a finite number"},
    {"coordinate_infinite", curve_with(points(4, "<control_point x='0' y='-inf'/>")),
     "a.xml:2:29: y of <control_point> is \"-inf\"; use a finite number"},
    {"coordinate_1e308", curve_with(points(4, "<control_point x='1e308' y='0'/>")),
     "a.xml:2:29: x of <control_point> is 1e308; use a magnitude of at most 10000000"},
    {"coordinate_1e309", curve_with(points(4, "<control_point x='1e309' y='0'/>")),
     "a.xml:2:29: x of <control_point> is \"1e309\"; use a finite number"},
    {"coordinate_words", curve_with(points(4, "<control_point x='1,5' y='0'/>")),
     "a.xml:2:29: x of <control_point> is \"1,5\"; use a finite number"},
    {"coordinate_missing", curve_with(points(4, "<control_point x='1'/>")),
     "a.xml:2:29: <control_point> has no attribute y"},
    {"colour_missing",
     curve_with(points(4) + "\n<left_colors_set><left_color R='1' B='1' globalID='0'/>"
                            "</left_colors_set>"),
     "a.xml:3:18: <left_color> has no attribute G"},
    {"colour_nan",
     curve_with(points(4) + "\n<left_colors_set><left_color R='1' G='nan' B='1' globalID='0'/>"
                            "</left_colors_set>"),
     "a.xml:3:18: G of <left_color> is \"nan\"; use a finite number"},
    {"stop_without_place",
     curve_with(points(4) + "\n<left_colors_set><left_color R='1' G='1' B='1'/>"
                            "</left_colors_set>"),
     "a.xml:3:18: <left_color> has no attribute globalID"},
    {"blur_infinite",
     curve_with(points(4) + "\n<blur_points_set><best_scale value='inf' globalID='0'/>"
                            "</blur_points_set>"),
     "a.xml:3:18: value of <best_scale> is \"inf\"; use a finite number"},
};

INSTANTIATE_TEST_SUITE_P(, BadOrzan, testing::ValuesIn(kBadInputs),
                         [](const auto& input) { return std::string(input.param.name); });

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

TEST(OrzanLimits, one_million_curves_are_refused) {
  const Status status = status_of(kHead + repeated("<curve/>", 1'000'000) + "</curve_set>");
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(to_string(status), "a.xml:1:1: more than the limit of 200000 curves");
  EXPECT_EQ(status.limit, "curves");
}

TEST(OrzanLimits, more_control_points_than_the_limit_are_refused) {
  const Status status = status_of(curve_with(
      "<control_points_set>" + repeated("<control_point/>", 3 * (limits::kControlPoints / 3) + 4) +
      "</control_points_set>"));
  EXPECT_EQ(status.code, StatusCode::limit);
}

TEST(OrzanLimits, more_stops_in_one_list_than_the_limit_are_refused) {
  const std::string color = "<left_color R='1' G='2' B='3' globalID='0'/>";
  const Status status =
      status_of(curve_with(points(4) + "<left_colors_set>" +
                           repeated(color, limits::kStopsPerList + 1) + "</left_colors_set>"));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_TRUE(status.message.starts_with("more than the limit of 10000 stops in one list"))
      << status.message;
}

TEST(OrzanLimits, input_longer_than_the_limit_is_refused) {
  const Status status = status_of(std::string(limits::kInputBytes + 1, ' '));
  EXPECT_EQ(status.code, StatusCode::limit);
}

TEST(OrzanLimits, more_elements_than_the_limit_are_refused) {
  const Status status = status_of(kHead + repeated("<a/>", limits::kXmlElements) + "</curve_set>");
  EXPECT_EQ(status.code, StatusCode::limit);
}

TEST(OrzanLimits, elements_nested_deeper_than_the_limit_are_refused) {
  const auto nested = [](std::size_t depth) {
    return kHead + repeated("<a>", depth - 1) + repeated("</a>", depth - 1) + "</curve_set>";
  };
  EXPECT_TRUE(status_of(nested(limits::kXmlDepth)).ok());
  const Status status = status_of(nested(limits::kXmlDepth + 1));
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.where.column, 3 * static_cast<int>(limits::kXmlDepth) - 2);
  EXPECT_EQ(status_of(nested(1'000'000)).code, StatusCode::limit);
}

TEST(OrzanLimits, memory_is_charged_before_it_is_taken) {
  Context context;
  new (&context.budget) Budget(100'000);
  const std::string xml = kHead + repeated("<curve/>", 2'000) + "</curve_set>";
  const Status status = read_orzan(context, xml, "a.xml").status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(OrzanLimits, attributes_by_the_thousand_are_no_trouble) {
  std::string attributes;
  for (int i = 0; i < 16'000; ++i) attributes += " a" + std::to_string(i) + "='1'";
  const std::string xml = "<curve_set image_width='3' image_height='2'" + attributes + "/>";
  EXPECT_EQ(status_of(xml).code, StatusCode::limit);
  EXPECT_TRUE(status_of(xml, {.xml_attributes = 16'384}).ok());
}

}  // namespace
}  // namespace sfumato
