#include "output/output_size.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "sfumato/base/limits.hpp"

namespace sfumato::output {
namespace {

const Box kWide{{0, 0}, {400, 300}};

TEST(OutputSize, is_one_pixel_per_unit_by_default) {
  const Result<OutputSize> size = output_size(Limits{}, {}, kWide);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 400);
  EXPECT_EQ(size->height, 300);
  EXPECT_EQ(size->pixels_per_unit, 1);
}

TEST(OutputSize, is_the_drawings_own_unless_asked_otherwise) {
  Document document;
  document.artboard = kWide;
  EXPECT_EQ(own_scale(document), (Vec2{1, 1}));
  document.size_px = Vec2{800, 900};
  const Vec2 own = own_scale(document);
  EXPECT_EQ(own, (Vec2{2, 3}));
  const auto size = [&](const SizeRequest& request) {
    const OutputSize found = *output_size(Limits{}, request, kWide, own);
    return std::pair(found.width, found.height);
  };
  EXPECT_EQ(size({}), std::pair(800, 900));
  EXPECT_EQ(size({.scale = 1}), std::pair(400, 300));
  EXPECT_EQ(size({.width = 400}), std::pair(400, 450));
  EXPECT_EQ(size({.height = 90}), std::pair(80, 90));
  EXPECT_EQ(size({.width = 10, .height = 90}), std::pair(10, 90));
  EXPECT_EQ(output_scale({}, kWide, own), 3);
}

TEST(OutputSize, scales_the_viewport_and_rounds_to_whole_pixels) {
  const Result<OutputSize> size = output_size(Limits{}, {.scale = 0.333}, kWide);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 133);
  EXPECT_EQ(size->height, 100);
  EXPECT_EQ(size->pixels_per_unit, 0.333);
}

TEST(OutputSize, follows_the_aspect_from_one_side) {
  const Result<OutputSize> from_width = output_size(Limits{}, {.width = 800}, kWide);
  ASSERT_TRUE(from_width);
  EXPECT_EQ(from_width->height, 600);
  EXPECT_EQ(from_width->pixels_per_unit, 2);
  const Result<OutputSize> from_height = output_size(Limits{}, {.height = 150}, kWide);
  ASSERT_TRUE(from_height);
  EXPECT_EQ(from_height->width, 200);
  EXPECT_EQ(from_height->pixels_per_unit, 0.5);
}

TEST(OutputSize, stretches_to_both_sides_and_tells_the_finer_scale) {
  const Result<OutputSize> size = output_size(Limits{}, {.width = 400, .height = 900}, kWide);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 400);
  EXPECT_EQ(size->height, 900);
  EXPECT_EQ(size->pixels_per_unit, 3);
}

TEST(OutputSize, is_never_below_one_pixel) {
  const Result<OutputSize> size = output_size(Limits{}, {.scale = 1e-9}, kWide);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 1);
  EXPECT_EQ(size->height, 1);
}

TEST(OutputSize, of_an_image_that_is_drawn_in_windows_has_a_limit_of_its_own) {
  const auto code = [](int width) {
    return output_size(Limits{}, {.width = width}, kWide, {1, 1}, true).status().code;
  };
  EXPECT_EQ(code(RasterWindow::kLargestSide), StatusCode::ok);
  EXPECT_EQ(code(RasterWindow::kLargestSide + 1), StatusCode::limit);
}

TEST(OutputSize, stops_at_the_limit_of_a_side) {
  EXPECT_TRUE(output_size(Limits{}, {.width = limits::kImageSide}, kWide));
  EXPECT_EQ(output_size(Limits{}, {.width = limits::kImageSide + 1}, kWide).status().code,
            StatusCode::limit);
  EXPECT_EQ(output_size(Limits{}, {.height = limits::kImageSide}, kWide).status().code,
            StatusCode::limit);
  EXPECT_EQ(output_size(Limits{}, {.scale = 1e300}, kWide).status().code, StatusCode::limit);
  EXPECT_EQ(output_size(Limits{}, {.scale = 1}, {{0, 0}, {1e7, 1}}).status().code,
            StatusCode::limit);
}

}  // namespace
}  // namespace sfumato::output
