// trace(): pictures of thin strokes, as pages of text are.
#include <gtest/gtest.h>

#include <string>

#include "support/flat_art.hpp"
#include "support/stroke_page.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

TEST(TraceStrokes, letters_are_there_with_as_many_points_as_they_need) {
  const Image page = test::stroke_page(8, 4);
  TraceStats few, all;
  test::trace_of(page, {.points = 60}, &few);
  ASSERT_GT(few.points_needed, 60u);
  const Document drawing =
      test::trace_of(page, {.points = static_cast<int>(few.points_needed)}, &all);
  EXPECT_GE(test::rendered_psnr_db(drawing, page), 20);
  EXPECT_EQ(all.points_needed, 0u);
}

TEST(TraceStrokes, most_letters_are_there_with_fewer_points) {
  const Image page = test::stroke_page(8, 4);
  EXPECT_GE(test::rendered_psnr_db(test::trace_of(page, {.points = 520}), page), 18);
}

TEST(TraceStrokes, few_points_make_a_drawing) {
  const Image page = test::stroke_page(12, 8);
  const Document drawing = test::trace_of(page, {.points = 300});
  EXPECT_GT(test::curve_count(drawing), 5u);
  EXPECT_LE(test::point_count(drawing), 300u);
}

TEST(TraceStrokes, other_pictures_need_no_number_of_points) {
  TraceStats stats;
  test::trace_of(test::synthetic_photo(120), {.points = 30}, &stats);
  EXPECT_EQ(stats.points_needed, 0u);
  for (const std::string name : {"gear", "map", "flag", "logo", "face", "fish"}) {
    Context context;
    const Result<Image> picture = test::flat_picture(context, name, true);
    ASSERT_TRUE(picture.ok()) << to_string(picture.status());
    test::trace_of(*picture, {.points = 30, .edges_only = true}, &stats);
    EXPECT_EQ(stats.points_needed, 0u) << name;
  }
}

}  // namespace
}  // namespace sfumato
