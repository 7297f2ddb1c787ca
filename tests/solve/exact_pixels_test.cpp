#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "picture/point_fields.hpp"
#include "sfumato/api/render_pixels.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "sfumato/picture/picture_file.hpp"
#include "sfumato/solve/point_evaluator.hpp"
#include "solve/pixel_pictures.hpp"

// Pictures for a pixel grid whose dense layers are gathered at their pixels.
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

/// Returns small circles, each in other colours.
std::vector<Curve> bubbles() {
  std::vector<Curve> curves;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const auto shade = static_cast<float>((row * 8 + column) % 7) / 7;
      const Vec2 center{6.3 + 12.5 * column, 6.1 + 12.4 * row};
      curves.push_back(colored(circle_curve(center, 4.7), Rgb{shade, 1 - shade, 0.5f},
                               Rgb{0.2f, shade, 1 - shade}));
    }
  }
  return curves;
}

Document dense() {
  return one_layer(bubbles());
}

DiffuseOptions every_pixel() {
  DiffuseOptions options;
  options.exact_pixels = true;
  return options;
}

bool is_exact(const Document& document, const DiffuseOptions& options = grid()) {
  return solved(document, options).layers[0].exact_points.get() != nullptr;
}

TEST(ExactPixels, a_dense_layer_has_them) {
  EXPECT_TRUE(is_exact(dense()));
}

TEST(ExactPixels, other_layers_have_patches) {
  EXPECT_FALSE(is_exact(dense(), {})) << "no pixel grid";
  EXPECT_FALSE(is_exact(one_layer({colored(circle_curve({50, 50}, 40), test::kRed, test::kBlue)})))
      << "sparse";
  DiffuseOptions rays = grid();
  rays.gather.method = gather::Method::rays;
  EXPECT_FALSE(is_exact(dense(), rays)) << "random rays";
  Document twice = dense();
  twice.stack.push_back(LayerInstance{0, {1, 0, 0, 1, 3, 0}});
  EXPECT_FALSE(is_exact(twice)) << "two instances";
  Document open = dense();
  open.layers[0].curves[5].left.color = {};
  EXPECT_FALSE(is_exact(open)) << "a side without colour";
  Document clear = dense();
  for (Curve& curve : clear.layers[0].curves) curve = test::with_opacity(curve, 0.5f, 1);
  EXPECT_FALSE(is_exact(clear)) << "opacity";
  Document linear = dense();
  linear.interpolation = InterpolationSpace::linear;
  EXPECT_FALSE(is_exact(linear)) << "another space";
}

TEST(ExactPixels, interpolated_pixels_are_near_those_of_the_gather_at_every_pixel) {
  const Image some = drawn(solved(dense(), grid())), all = drawn(solved(dense(), every_pixel()));
  EXPECT_LE(largest_difference(some, all), 3);
}

TEST(ExactPixels, a_part_that_surrounds_another_has_its_own_colour) {
  // The centroid of the part outside of such a circle lies in the circle.
  constexpr double kRadius = 0.3;
  std::vector<Curve> curves;
  for (int i = 0; i < 400; ++i) {
    const Vec2 center{2.5 + 5 * (i % 20), 2.5 + 5 * (i / 20)};
    curves.push_back(colored(circle_curve(center, kRadius), test::kGreen, test::kRed));
  }
  const Picture picture = solved(one_layer(curves), grid());
  ASSERT_TRUE(picture.layers[0].exact_points);
  const Image image = drawn(picture);
  const double share = std::numbers::pi * kRadius * kRadius;
  for (int i = 0; i < 400; ++i) {
    const std::size_t at = 3 * (100 * (2 + std::size_t{5} * (i / 20)) + 2 + 5 * (i % 20));
    ASSERT_NEAR(image.bytes[at], 255 * share, 3) << i;
    ASSERT_NEAR(image.bytes[at + 1], 255 * (1 - share), 3) << i;
  }
}

TEST(ExactPixels, windows_have_the_bytes_of_the_whole_image) {
  test::expect_equal_windows(solved(dense(), grid()));
}

TEST(ExactPixels, threads_and_instruction_sets_change_no_byte) {
  RasterOptions options = plain_options();
  options.width = options.height = 400;
  DiffuseOptions large = grid();
  large.pixels_per_unit = 4;
  std::optional<Image> first;
  for (const int threads : {1, 3}) {
    for (SimdLevel level = SimdLevel::sse2; level <= detected_simd_level();
         level = static_cast<SimdLevel>(static_cast<int>(level) + 1)) {
      ThreadPool pool(threads);
      Context context;
      context.executor = &pool;
      context.simd = level;
      const Image image = drawn(solved(dense(), large, context), options, context);
      if (!first) first = image;
      EXPECT_EQ(image.bytes, first->bytes) << threads << ' ' << static_cast<int>(level);
    }
  }
}

TEST(ExactPixels, a_picture_outlives_its_context_and_charges_nothing) {
  std::optional<Picture> picture;
  {
    Context context;
    picture = solved(dense(), grid(), context);
    EXPECT_EQ(context.budget.used(), 0u);
  }
  EXPECT_GT(bytes_of(*picture), 10'000u);
  const Picture copy = *picture;
  picture.reset();
  EXPECT_EQ(drawn(copy).bytes, drawn(solved(dense(), grid())).bytes);
}

TEST(ExactPixels, no_picture_file_is_written) {
  for (const DiffuseOptions& options : {grid(), every_pixel()}) {
    Context context;
    const Status status = write_picture(context, solved(dense(), options)).status();
    EXPECT_EQ(status.code, StatusCode::bad_input);
  }
}

TEST(ExactPixels, drawing_can_be_cancelled_and_has_a_memory_limit) {
  const Picture picture = solved(dense(), grid());
  Context cancelled;
  cancelled.cancel = true;
  EXPECT_EQ(rasterize(cancelled, picture, plain_options()).status().code, StatusCode::cancelled);
  Context small{.budget = Budget(300'000)};
  EXPECT_EQ(rasterize(small, picture, plain_options()).status().limit, "memory");
}

/// Compares pixels that are not antialiased with the fields at their centres.
void expect_fields_at_centres(const Document& document) {
  Context context;
  RasterOptions options = plain_options();
  options.background.reset();
  options.antialias = false;
  options.format = PixelFormat::rgba16;
  const Result<Image> image = render_pixels(context, document, {}, options);
  ASSERT_TRUE(image.ok()) << image.status().message;
  const Result<PointEvaluator> evaluator = PointEvaluator::create(context, document, {});
  ASSERT_TRUE(evaluator.ok());
  for (const int place : {1205, 3377, 5050, 7719, 9999, 4}) {
    const int x = place % 100, y = place / 100;
    const Vec2 point{x + 0.5, y + 0.5};
    float color[3], opacity[1] = {1};
    std::uint8_t hit[1];
    const bool has_opacity = evaluator->opacity_channels(0) > 0;
    ASSERT_TRUE(evaluator
                    ->evaluate(context, 0, {&point, 1}, color, hit,
                               has_opacity ? std::span<float>(opacity) : std::span<float>())
                    .ok());
    std::uint16_t shown[4];
    std::memcpy(shown, image->bytes.data() + std::size_t{8} * (100 * y + x), sizeof(shown));
    const double alpha = hit[0] ? std::clamp(opacity[0], 0.0f, 1.0f) : 0;
    EXPECT_NEAR(shown[3] / 65535.0, alpha, 1e-3) << place;
    for (int c = 0; alpha > 0.01 && c < 3; ++c)
      EXPECT_NEAR(shown[c] / 65535.0, color[c], 2e-3) << place;
  }
}

TEST(ExactPixels, every_pixel_has_the_fields_of_its_centre) {
  expect_fields_at_centres(dense());
  Document clear = dense();
  for (Curve& curve : clear.layers[0].curves) curve = test::with_opacity(curve, 0.2f, 0.8f);
  expect_fields_at_centres(clear);
  // The opacity has curves of its own.
  clear.layers[0].curves[3].left.opacity = {};
  clear.layers[0].curves[3].right.opacity = {};
  expect_fields_at_centres(clear);
  // Most of the picture sees no colour.
  Curve wave{.control_points = {{20, 50}, {40, 60}, {60, 40}, {80, 50}}};
  wave.left.color = test::one_color(test::kRed);
  expect_fields_at_centres(one_layer({wave}));
}

/// Returns shapes that are opaque inside and clear outside: a disk, one smaller than a pixel, and a
/// thin lens from edge to edge.
Document shapes() {
  const Curve lens{
      .control_points = {{2, 90}, {30, 90.4}, {70, 90.4}, {98, 90}, {70, 91}, {30, 91}, {2, 90}}};
  std::vector<Curve> curves = {circle_curve({24.2, 23.7}, 9), circle_curve({81.4, 22.6}, 0.4),
                               lens};
  for (Curve& curve : curves)
    curve = test::with_opacity(colored(curve, test::kWhite, test::kRed), 0, 1);
  return one_layer(curves);
}

TEST(ExactPixels, clear_pixels_are_not_gathered) {
  const Picture exact = solved(shapes(), every_pixel());
  const Image image = drawn(exact);
  EXPECT_LE(largest_difference(image, drawn(solved(shapes(), {}))), 4);
  const std::uint64_t most = 100 * 100 / 2;
  EXPECT_LT(exact.layers[0].exact_points.get()->read_count(), most);
}

TEST(ExactPixels, windows_of_clear_pixels_have_the_bytes_of_the_whole_image) {
  test::expect_equal_windows(solved(shapes(), every_pixel()));
}

TEST(ExactPixels, curves_are_antialiased_at_every_pixel) {
  const Document disk =
      one_layer({colored(circle_curve({50.3, 49.6}, 37.4), test::kWhite, test::kRed)});
  Context context;
  RasterOptions options = plain_options();
  const Result<Image> image = render_pixels(context, disk, {}, options);
  ASSERT_TRUE(image.ok());
  EXPECT_LE(largest_difference(*image, drawn(solved(disk, {}))), 1);
  options.antialias = false;
  const Result<Image> rough = render_pixels(context, disk, {}, options);
  ASSERT_TRUE(rough.ok());
  EXPECT_TRUE(std::ranges::all_of(rough->bytes, [](std::uint8_t b) { return b == 0 || b == 255; }));
}

}  // namespace
}  // namespace sfumato
