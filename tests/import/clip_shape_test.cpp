// The basic shapes of CSS clip.
#include <gtest/gtest.h>

#include "sfumato/base/box.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

ImportedSvg shaped_drawing(const std::string& content) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "shape.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

/// Returns the box of all control points, rounded, and the number of warnings if there are any.
std::string shaped_box(const std::string& content) {
  const ImportedSvg made = shaped_drawing(content);
  Box box;
  for (const Layer& layer : made.document.layers) {
    for (const Curve& curve : layer.curves) {
      for (const Vec2 point : curve.control_points) box.extend(point);
    }
  }
  if (box.empty()) return "nothing";
  char text[80];
  std::snprintf(text, sizeof text, "%.0f %.0f %.0f %.0f", box.min.x, box.min.y, box.max.x,
                box.max.y);
  const std::size_t warnings = made.warnings.size();
  return text + (warnings > 0 ? " !" + std::to_string(warnings) : "");
}

/// Returns a rectangle of 60 × 40 at (20, 30), clipped by a declaration.
std::string clipped_by(const std::string& value, const std::string& attributes = "") {
  return shaped_box("<rect x='20' y='30' width='60' height='40' " + attributes +
                    " style=\"clip-path:" + value + "\"/>");
}

TEST(ImportClipShape, circles_and_ellipses) {
  EXPECT_EQ(clipped_by("circle()"), "30 30 70 70");
  EXPECT_EQ(clipped_by("circle(10px at 30px 20px)"), "40 40 60 60");
  EXPECT_EQ(clipped_by("circle(10px at right 10px bottom 10px)"), "60 50 80 70");
  EXPECT_EQ(clipped_by("circle(10px at left)"), "20 40 30 60");
  EXPECT_EQ(clipped_by("circle(farthest-side)"), "20 30 80 70");
  EXPECT_EQ(clipped_by("ellipse(10px 5px)"), "40 45 60 55");
  EXPECT_EQ(clipped_by("ellipse(50% 25%)"), "20 40 80 60");
  EXPECT_EQ(clipped_by("circle(0)"), "nothing");
}

TEST(ImportClipShape, rectangles) {
  EXPECT_EQ(clipped_by("inset(10px)"), "30 40 70 60");
  EXPECT_EQ(clipped_by("inset(5px 10% 10px 20px round 4px)"), "40 35 74 60");
  EXPECT_EQ(clipped_by("inset(30px)"), "nothing");
  EXPECT_EQ(clipped_by("rect(5px 30px 20px auto)"), "20 35 50 50");
  EXPECT_EQ(clipped_by("xywh(5px 6px 20px 25%)"), "25 36 45 46");
  // Corners that are too large shrink together.
  EXPECT_EQ(clipped_by("inset(0 round 500px)"), "20 30 80 70");
}

TEST(ImportClipShape, polygons_and_paths) {
  EXPECT_EQ(clipped_by("polygon(0 0, 50% 0, 50% 50%)"), "20 30 50 50");
  EXPECT_EQ(clipped_by("path('M5 5H20V10Z')"), "25 35 40 40");
  const std::string twice = "M0 0H60V40H0ZM0 0H30V40H0Z";
  EXPECT_EQ(clipped_by("path(evenodd, '" + twice + "')"), "50 30 80 70");
  EXPECT_EQ(clipped_by("path('" + twice + "')"), "20 30 80 70");
}

TEST(ImportClipShape, boxes) {
  const std::string stroke = "stroke='red' stroke-width='10'";
  EXPECT_EQ(clipped_by("circle(50%)", stroke), "20 25 80 75");
  EXPECT_EQ(clipped_by("inset(0)", stroke), "15 25 85 75");
  EXPECT_EQ(clipped_by("inset(0) fill-box", stroke), "20 30 80 70");
  EXPECT_EQ(clipped_by("view-box inset(40px)"), "40 40 60 60");
  EXPECT_EQ(clipped_by("fill-box", stroke), "20 30 80 70");
  EXPECT_EQ(shaped_box("<svg x='10' y='10' width='50' height='50' viewBox='0 0 100 100'><rect "
                       "width='99' height='99' clip-path='inset(10px) view-box'/></svg>"),
            "15 15 55 55");
  const std::string path = "<path d='M20 20H80V60H20Z' stroke='red' stroke-width='4' ";
  EXPECT_EQ(shaped_box(path + "clip-path='inset(0)'/>"), "18 18 82 62 !1");
  EXPECT_EQ(shaped_box(path + "clip-path='inset(0) fill-box'/>"), "20 20 80 60");
}

TEST(ImportClipShape, groups_and_clips_have_them) {
  const std::string two =
      "<rect x='20' y='30' width='30' height='40'/>"
      "<rect x='60' y='30' width='20' height='40'/>";
  EXPECT_EQ(shaped_box("<g clip-path='inset(10px) fill-box'>" + two + "</g>"), "30 40 70 60");
  EXPECT_EQ(shaped_box("<clipPath id='c' clip-path='inset(0 0 0 70px) view-box'><rect width='99' "
                       "height='99'/></clipPath><g clip-path='url(#c)'>" +
                       two + "</g>"),
            "70 30 80 70");
  EXPECT_EQ(shaped_box("<clipPath id='c'><rect width='50' height='99' clip-path='inset(35px 0 0) "
                       "fill-box'/></clipPath><g clip-path='url(#c)'>" +
                       two + "</g>"),
            "20 35 50 70");
}

TEST(ImportClipShape, bad_values_clip_nothing) {
  for (const char* value :
       {"circle(-5px)", "circle(5px 6px)", "circle(5px at top 10px)", "circle(at left right)",
        "circle(5)", "ellipse(5px)", "inset()", "inset(5px round)", "polygon(1px)", "polygon()",
        "polygon(odd, 1px 2px)", "path(M0 0)", "star()", "circle() circle()", "fill-box view-box",
        "circle() none", "circle(calc(1px + 2px))", "10px"}) {
    EXPECT_EQ(clipped_by(value), "20 30 80 70 !1") << value;
    EXPECT_EQ(clipped_by("inset(10px);clip-path:" + std::string(value)), "30 40 70 60 !1") << value;
  }
  EXPECT_EQ(clipped_by("path('M0 0L')"), "20 30 80 70 !1");
  EXPECT_EQ(shaped_box("<rect width='60' height='40' clip-path='circle(-5px)'/>"), "0 0 60 40 !1");
  // An attribute may omit units.
  EXPECT_EQ(shaped_box("<rect width='60' height='40' clip-path='circle(10)'/>"), "20 10 40 30");
}

}  // namespace
}  // namespace sfumato
