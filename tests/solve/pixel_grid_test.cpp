#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sfumato/picture/picture_file.hpp"
#include "sfumato/solve/solution.hpp"
#include "solve/pixel_pictures.hpp"

// Pictures for a pixel grid: coarse chords whose bows the pixels correct.
namespace sfumato {
namespace {

using test::circle_curve;
using test::colored;
using test::drawn;
using test::grid;
using test::largest_difference;
using test::one_layer;
using test::plain_options;
using test::solved;

Document disk() {
  return one_layer({colored(circle_curve({50.3, 49.6}, 37.4), test::kWhite, test::kRed)});
}

/// Returns a disk with opacity 1 inside and 0 outside.
Document sticker() {
  Document document = disk();
  Curve& curve = document.layers[0].curves[0];
  curve = test::with_opacity(curve, 0, 1);
  return document;
}

/// Returns a disk on a transparent layer: its curve has no colour on the outer side.
Document cutout() {
  Document document = disk();
  document.layers[0].curves[0].left.color = {};
  document.layers[0].curves[0].left.color.kind = ShaderKind::barrier;
  return document;
}

/// Returns two circles 0.35 pixels apart. One is rotated, so that their chords have different ends.
Document ring() {
  Curve outer = circle_curve({50, 50}, 30.35);
  for (Vec2& p : outer.control_points) {
    const Vec2 from = p - Vec2{50, 50};
    constexpr double kTurn = 0.4;
    p = Vec2{50 + from.x * std::cos(kTurn) - from.y * std::sin(kTurn),
             50 + from.x * std::sin(kTurn) + from.y * std::cos(kTurn)};
  }
  return one_layer({colored(circle_curve({50, 50}, 30), test::kBlue, test::kWhite),
                    colored(outer, test::kRed, test::kBlack)});
}

DiffuseOptions fine() {
  DiffuseOptions options;
  options.tolerance = 0.001;
  return options;
}

class PixelGridOf : public testing::TestWithParam<Document (*)()> {};

TEST_P(PixelGridOf, has_fewer_triangles_and_the_pixels_of_fine_chords) {
  const Document document = GetParam()();
  const Picture picture = solved(document, grid()), exact = solved(document, fine());
  EXPECT_TRUE(picture.for_pixel_grid);
  EXPECT_FALSE(picture.layers[0].bow.empty());
  EXPECT_LT(3 * picture.layers[0].triangle_count(), exact.layers[0].triangle_count());
  EXPECT_LE(largest_difference(drawn(picture), drawn(exact)), 3);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PixelGridOf, testing::Values(disk, sticker, cutout));

TEST(PixelGrid, windows_have_the_bytes_of_the_whole_image) {
  test::expect_equal_windows(solved(disk(), grid()));
}

TEST(PixelGrid, pixels_need_the_bows) {
  Picture picture = solved(disk(), grid());
  picture.layers[0].bow.clear();
  EXPECT_GT(largest_difference(drawn(picture), drawn(solved(disk(), fine()))), 8);
}

TEST(PixelGrid, curves_within_a_pixel_of_each_other_do_not_cross) {
  const Image near = drawn(solved(ring(), grid()));
  const Image exact = drawn(solved(ring(), fine()));
  EXPECT_LE(largest_difference(near, exact), 24);
  // Far from the ring each side has its one colour: nothing shows through it.
  const auto pixel = [&](int x, int y) { return &near.bytes[std::size_t{3} * (100 * y + x)]; };
  EXPECT_EQ(pixel(50, 50)[1], 255);
  EXPECT_EQ(pixel(5, 5)[1], 0);
}

TEST(PixelGrid, a_bow_shows_only_where_its_curve_jumps) {
  Document document = disk();
  document.layers[0].curves[0].right.color.stops.stops[0].value = test::kWhite;
  const Image image = drawn(solved(document, grid()));
  EXPECT_TRUE(std::ranges::all_of(image.bytes, [](std::uint8_t b) { return b == 255; }));
}

TEST(PixelGrid, has_no_effect_beside_a_tolerance_or_on_the_papers_mesh) {
  DiffuseOptions given = grid();
  given.tolerance = 0.1;
  DiffuseOptions paper = grid();
  paper.max_error = 0;
  for (const DiffuseOptions& options : {given, paper}) {
    const Picture picture = solved(disk(), options);
    EXPECT_FALSE(picture.for_pixel_grid);
    EXPECT_TRUE(picture.layers[0].bow.empty());
  }
}

TEST(PixelGrid, a_border_of_what_sees_a_curve_is_where_fine_chords_have_it) {
  // Below the curve nothing sees its only side, and how far one sees it beside its end depends on
  // the directions of chords.
  Curve wave{.control_points = {{20, 50}, {40, 60}, {60, 40}, {80, 50}}};
  wave.left = {.color = test::one_color(test::kRed), .opacity = test::one_opacity(1)};
  const Document document = one_layer({wave});
  const Picture picture = solved(document, grid());
  EXPECT_TRUE(picture.for_pixel_grid);
  EXPECT_TRUE(picture.layers[0].bow.empty());
  EXPECT_EQ(drawn(picture).bytes, drawn(solved(document, {})).bytes);
}

TEST(PixelGrid, a_larger_instance_has_finer_chords) {
  Document document = disk();
  DiffuseOptions options = grid();
  options.viewport = Box{{-200, -200}, {500, 500}};
  const auto bows = [&] { return solved(document, options).layers[0].bow.size(); };
  const std::size_t at_its_size = bows();
  std::get<LayerInstance>(document.stack[0]).artboard_from_layer = {4, 0, 0, 4, 0, -150};
  EXPECT_GT(bows(), at_its_size);
}

TEST(PixelGrid, no_picture_file_is_written) {
  Context context;
  const Status status = write_picture(context, solved(disk(), grid())).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_NE(status.message.find("solve without pixel_grid"), std::string::npos) << status.message;
}

TEST(PixelGrid, a_solution_has_the_picture_of_diffuse_and_drags_none) {
  Context context;
  Result<Solution> solution = Solution::create(context, disk());
  ASSERT_TRUE(solution.ok());
  solution->expect_drags(1'000'000);
  ASSERT_TRUE(solution->solve(context, grid()).ok());
  EXPECT_EQ(drawn(solution->picture()).bytes, drawn(solved(disk(), grid())).bytes);
  EXPECT_EQ(solution->begin_drag(context, 0, {0}).code, StatusCode::bad_input);
  EXPECT_EQ(solution->solve_roughly(context, grid()).code, StatusCode::bad_input);
  EXPECT_EQ(solution->solve_next(context, grid()).code, StatusCode::bad_input);
  ASSERT_TRUE(solution->solve(context, {}).ok());
  EXPECT_FALSE(solution->picture().for_pixel_grid);
  EXPECT_TRUE(solution->begin_drag(context, 0, {0}).ok());
}

}  // namespace
}  // namespace sfumato
