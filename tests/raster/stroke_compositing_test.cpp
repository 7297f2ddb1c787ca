#include <gtest/gtest.h>

#include <memory>

#include "raster/pictures.hpp"
#include "raster/support.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::test {
namespace {

constexpr Box kStrokesBox{{0, 0}, {80, 60}};

/// Returns a straight stroke of one colour along y = 30, opaque on its axis.
LocalStroke straight_stroke(const Rgb& color, float radius) {
  LocalStroke stroke;
  stroke.curve.control_points = {{-100, 30}, {0, 30}, {80, 30}, {180, 30}};
  stroke.curve.left_color.stops = {{0, color}};
  stroke.curve.right_color.stops = {{0, color}};
  stroke.curve.influence_radius.stops = {{0, radius}};
  return stroke;
}

Picture white_picture() {
  return make_picture(flat_layer(kStrokesBox, {1, 1, 1}));
}

TEST(RasterStrokes, a_stroke_lies_at_its_place_in_the_stack) {
  Picture picture = white_picture();
  picture.layers.push_back(flat_layer(kStrokesBox, {0, 0, 1}));
  const Affine right_half{0.5, 0, 0, 1, 40, 0};
  picture.stack = {PatchInstance{0, {}}, straight_stroke({1, 0, 0}, 12),
                   PatchInstance{1, right_half}};
  for (PixelFormat format : {PixelFormat::rgb16, PixelFormat::rgba16}) {
    const Image image = rasterized(picture, image_size(80, 60, format));
    EXPECT_GT(channel(image, 20, 30, 0), 65000);
    EXPECT_LT(channel(image, 20, 30, 1), 2000);
    EXPECT_EQ(channel(image, 20, 5, 1), 65535);
    EXPECT_EQ(channel(image, 60, 30, 0), 0);
    EXPECT_EQ(channel(image, 60, 30, 2), 65535);
  }
}

TEST(RasterStrokes, a_stroke_on_nothing_keeps_its_colour_and_opacity_apart) {
  Picture picture = white_picture();
  picture.stack = {straight_stroke({0.8f, 0.4f, 0.2f}, 12)};
  const Image image = rasterized(picture, image_size(300, 225, PixelFormat::rgba16));
  EXPECT_NEAR(channel(image, 150, 112, 3), 65535, 1000);
  EXPECT_EQ(channel(image, 150, 20, 3), 0);
  int partial = 0;
  for (int y = 0; y < 225; ++y) {
    const int alpha = channel(image, 150, y, 3);
    if (alpha < 500) continue;
    partial += alpha < 60000;
    EXPECT_NEAR(channel(image, 150, y, 0), 65535 * 0.8, 100);
    EXPECT_NEAR(channel(image, 150, y, 2), 65535 * 0.2, 100);
  }
  EXPECT_GT(partial, 30);
}

TEST(RasterStrokes, a_stroke_in_a_faded_group_is_as_faint_as_the_group) {
  Picture picture = white_picture();
  picture.stack = {PatchInstance{0, {}}, GroupBegin{0.5f, {}}, straight_stroke({0, 0, 0}, 12),
                   GroupEnd{}};
  const Image group = rasterized(picture, image_size(300, 225));
  picture.stack = {PatchInstance{0, {}}, straight_stroke({0, 0, 0}, 12)};
  const Image alone = rasterized(picture, image_size(300, 225));
  for (int y = 0; y < 225; ++y)
    EXPECT_NEAR(65535 - channel(group, 77, y, 1), (65535 - channel(alone, 77, y, 1)) / 2.0, 2);
}

TEST(RasterStrokes, strokes_give_the_same_bytes_for_any_number_of_threads_and_instruction_set) {
  Picture picture = white_picture();
  picture.interpolation = InterpolationSpace::oklab;
  for (int i = 0; i < 40; ++i) {
    LocalStroke stroke =
        straight_stroke({static_cast<float>(i) / 40, 0.1f, 0.2f}, 1 + static_cast<float>(i % 7));
    stroke.artboard_from_stroke = {0.3, 0.02 * i, -0.02 * i, 0.3, 1.5 * i, 1.0 * i};
    picture.stack.push_back(stroke);
  }
  const RasterOptions options = image_size(700, 500, PixelFormat::rgba16);
  const Image alone = rasterized(picture, options);
  ThreadPool executor(4);
  for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
    if (level > detected_simd_level()) continue;
    Context context;
    context.simd = level;
    context.executor = &executor;
    const Result<Image> image = rasterize(context, picture, options);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->bytes, alone.bytes) << static_cast<int>(level);
  }
}

TEST(RasterStrokes, a_stroke_that_is_none_is_bad_input) {
  Picture picture = white_picture();
  picture.stack = {LocalStroke{}};
  Context context;
  EXPECT_EQ(rasterize(context, picture, image_size(9, 9)).status().code, StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato::test
