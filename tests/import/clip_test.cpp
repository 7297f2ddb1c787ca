// clip-path and viewports cut shapes.
#include <gtest/gtest.h>

#include "sfumato/base/box.hpp"
#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

ImportedSvg clipped_drawing(const std::string& content) {
  Context context;
  auto result = import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "clip.svg");
  EXPECT_TRUE(result) << (result ? "" : result.status().message);
  return result ? std::move(*result) : ImportedSvg{};
}

/// Returns the box of all control points, rounded to 1/100.
std::string drawn_box(const ImportedSvg& made) {
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
  return text;
}

const std::string kClippedSquare =
    "<rect x='20' y='20' width='60' height='60' clip-path='url(#c)'/>";

std::string clip_path(const std::string& content, const std::string& attributes = "") {
  return "<clipPath id='c' " + attributes + ">" + content + "</clipPath>";
}

TEST(ImportClip, a_shape_is_cut_by_the_union_of_the_clips_shapes) {
  const std::string left = "<rect width='50' height='50'/>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(left) + kClippedSquare)), "20 20 50 50");
  const std::string two = left + "<circle cx='70' cy='70' r='5'/>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(two) + kClippedSquare)), "20 20 75 75");
}

TEST(ImportClip, an_empty_clip_leaves_nothing) {
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path("") + kClippedSquare)), "nothing");
  const std::string hidden = "<rect width='50' height='50' visibility='hidden'/>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(hidden) + kClippedSquare)), "nothing");
  const std::string apart = "<rect width='9' height='9'/>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(apart) + kClippedSquare)), "nothing");
}

TEST(ImportClip, units_of_the_box_and_transforms_count) {
  const std::string half = "<rect width='.5' height='1'/>",
                    units = "clipPathUnits='objectBoundingBox'";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(half, units) + kClippedSquare)), "20 20 50 80");
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(half, units + " transform='translate(30 0)'") +
                                      kClippedSquare)),
            "50 20 80 80");
  const std::string group =
      "<g clip-path='url(#c)'><rect x='20' y='20' width='40' height='40'/>"
      "<rect x='40' y='40' width='40' height='40'/></g>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path(half, units) + group)), "20 20 50 80");
  const std::string moved = "<g transform='translate(10 0) scale(.5)'>" + kClippedSquare + "</g>";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path("<rect width='50' height='99'/>") + moved)),
            "20 10 35 40");
}

TEST(ImportClip, clips_within_clips_intersect) {
  const std::string outer = "<clipPath id='o'><rect y='30' width='99' height='20'/></clipPath>";
  const std::string left = "<rect width='50' height='99'/>";
  EXPECT_EQ(
      drawn_box(clipped_drawing(outer + clip_path(left, "clip-path='url(#o)'") + kClippedSquare)),
      "20 30 50 50");
  EXPECT_EQ(drawn_box(clipped_drawing(
                outer + clip_path("<rect width='50' height='99' clip-path='url(#o)'/>") +
                kClippedSquare)),
            "20 30 50 50");
  EXPECT_EQ(drawn_box(clipped_drawing(outer + clip_path(left) + "<g clip-path='url(#o)'>" +
                                      kClippedSquare + "</g>")),
            "20 30 50 50");
}

TEST(ImportClip, clip_rule_decides_about_holes) {
  const std::string ring = "d='M20 20H80V80H20ZM20 20H50V80H20Z' ";
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path("<path " + ring + "clip-rule='evenodd'/>") +
                                      kClippedSquare)),
            "50 20 80 80");
  EXPECT_EQ(drawn_box(clipped_drawing(clip_path("<path " + ring + "/>") + kClippedSquare)),
            "20 20 80 80");
}

TEST(ImportClip, viewports_of_symbols_and_nested_pictures_cut) {
  const std::string big = "<rect x='-50' y='-50' width='110' height='110'/>";
  EXPECT_EQ(
      drawn_box(clipped_drawing("<svg x='10' y='10' width='30' height='20'>" + big + "</svg>")),
      "10 10 40 30");
  EXPECT_EQ(drawn_box(clipped_drawing("<svg width='30' height='20' overflow='visible'>" + big +
                                      "</svg>")),
            "-50 -50 60 60");
  EXPECT_EQ(
      drawn_box(clipped_drawing("<symbol id='s' viewBox='0 0 10 10'>" + big +
                                "</symbol><use href='#s' x='5' y='5' width='20' height='20'/>")),
      "5 5 25 25");
}

TEST(ImportClip, mistakes_clip_nothing_and_are_named) {
  for (const char* clip : {"", "<rect id='c'/>",
                           "<clipPath id='c' clip-path='url(#c)'><rect width='99' "
                           "height='99'/></clipPath>"}) {
    const ImportedSvg made = clipped_drawing(clip + kClippedSquare);
    EXPECT_EQ(drawn_box(made), "20 20 80 80") << clip;
    ASSERT_EQ(made.warnings.size(), 1u) << clip;
    EXPECT_NE(made.warnings[0].message.find("clip-path of"), std::string::npos);
  }
}

}  // namespace
}  // namespace sfumato
