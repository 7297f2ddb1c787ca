// A shape that needs too much work is left out, and the warning names the limit.
#include <gtest/gtest.h>

#include <string>

#include "sfumato/import/import_svg.hpp"

namespace sfumato {
namespace {

Result<ImportedSvg> imported_under(const Limits& limits, const std::string& content) {
  Context context{.limits = limits};
  return import_svg(
      context,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + content + "</svg>",
      "limits.svg");
}

const std::string kStar = "<path d='M50 0 L80 95 L0 35 H100 L20 95z'/>";

/// Returns the only warning about this drawing.
std::string limit_warning(const Limits& limits, const std::string& content) {
  const auto made = imported_under(limits, content);
  EXPECT_TRUE(made) << to_string(made.status());
  EXPECT_EQ(made ? made->warnings.size() : 0, 1u);
  return made && !made->warnings.empty() ? made->warnings[0].message : std::string();
}

TEST(ImportLimits, the_chords_of_a_shape_have_one) {
  Limits limits;
  limits.chords = 20;
  const std::string circle = "<circle cx='50' cy='50' r='40'/>";
  const std::string too_long =
      "the shape is left out: its outline is too long: more than the limit of 20 chords; raise the "
      "limit chords";
  EXPECT_EQ(limit_warning(limits, "<circle cx='9' cy='9' r='.001'/>" + circle), too_long);
  EXPECT_EQ(limit_warning(limits,
                          "<path fill='none' stroke='red' d='M0 0c9 0 9 9 0 9s9 9 0 9 9 9 "
                          "0 9 9 9 0 9'/>"),
            too_long);
  EXPECT_TRUE(imported_under({}, circle)->warnings.empty());
}

TEST(ImportLimits, its_chords_count_once_they_are_cut) {
  Limits limits;
  limits.chords = 12;
  EXPECT_EQ(limit_warning(limits, kStar),
            "the shape is left out: it crosses itself too often: more than the limit of 12 chords; "
            "raise the limit chords");
}

TEST(ImportLimits, the_pairs_of_chords_have_one) {
  Limits limits;
  limits.chord_pairs = 7;
  EXPECT_EQ(limit_warning(limits, kStar),
            "the shape is left out: it crosses itself too often: more than the limit of 7 pairs of "
            "chords; raise the limit chord-pairs");
}

TEST(ImportLimits, of_many_intricate_shapes_the_fifth_ends_the_import) {
  Limits limits;
  limits.chord_pairs = 7;
  const std::string four = kStar + kStar + kStar + kStar;
  EXPECT_EQ(limit_warning(limits, four), limit_warning(limits, kStar));
  const auto ended = imported_under(limits, four + "\n" + kStar);
  EXPECT_EQ(ended.status().code, StatusCode::limit);
  EXPECT_EQ(ended.status().limit, "chord-pairs");
  EXPECT_EQ(ended.status().message,
            "it crosses itself too often: more than the limit of 7 pairs of chords");
  EXPECT_EQ(ended.status().where.line, 2);
}

TEST(ImportLimits, the_lengths_of_dashes_have_one) {
  Limits limits;
  limits.dash_lengths = 2;
  const auto made =
      imported_under(limits, "<path d='M0 9H90' stroke='red' stroke-dasharray='9 2 3 4'/>");
  ASSERT_TRUE(made);
  ASSERT_EQ(made->warnings.size(), 1u);
  EXPECT_EQ(made->warnings[0].message,
            "stroke-dasharray of <path> has more than the limit of 2 lengths; the rest is left "
            "out; raise the limit dash-lengths");
}

TEST(ImportLimits, markers_within_each_other_have_one) {
  Limits limits;
  limits.marker_depth = 1;
  const auto made = imported_under(
      limits,
      "<marker id='a'><path d='M0 0H1' marker-end='url(#b)'/></marker><marker id='b'><circle "
      "r='1'/></marker><path d='M9 9H90' marker-end='url(#a)'/>");
  ASSERT_TRUE(made);
  ASSERT_EQ(made->warnings.size(), 1u);
  EXPECT_EQ(made->warnings[0].message,
            "markers of <path> are left out: more than the limit of 1 markers within each other; "
            "raise the limit marker-depth");
}

}  // namespace
}  // namespace sfumato
