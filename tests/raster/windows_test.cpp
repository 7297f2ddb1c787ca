#include "support/windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

constexpr int kFar = RasterWindow::kLargestSide;

/// Returns two colours that meet along x = at, from 0 to side; y from 0 to side.
Picture two_halves(double side, double at) {
  RegionMesh mesh;
  mesh.vertex = {{0, 0}, {at, 0}, {side, 0}, {side, side}, {at, side}, {0, side}};
  mesh.add(0, 1, 4, 0);
  mesh.add(0, 4, 5, 0);
  mesh.add(1, 2, 3, 1);
  mesh.add(1, 3, 4, 1);
  return make_picture(make_layer(mesh, [](int region, Vec2) {
    return region == 0 ? Rgb{0.8f, 0.2f, 0.1f} : Rgb{0.1f, 0.3f, 0.9f};
  }));
}

Status painted(const Picture& picture, const RasterOptions& options, const Limits& limits = {}) {
  Context context{.limits = limits};
  return rasterize(context, picture, options).status();
}

TEST(RasterWindows, that_no_image_holds_are_bad_input) {
  const Picture picture = two_halves(64, 32);
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  const RasterWindow wrong[] = {{-1, 0, 64, 64},       {0, -1, 64, 64},     {33, 0, 64, 64},
                                {0, 33, 64, 64},       {0, 0, 31, 64},      {0, 0, 64, 0},
                                {0, 0, -64, 64},       {kMost, 0, 64, 64},  {0, kMost, 64, 64},
                                {kLeast, 0, 64, 64},   {0, kLeast, 64, 64}, {64, 64, 64, 64},
                                {kMost, kMost, 64, 64}};
  for (const RasterWindow& window : wrong) {
    RasterOptions options = image_size(32, 32);
    options.window = window;
    EXPECT_EQ(painted(picture, options).code, StatusCode::bad_input) << window.x << ' ' << window.y;
  }
}

TEST(RasterWindows, bound_the_large_image_and_themselves) {
  const Picture picture = two_halves(64, 32);
  RasterOptions options = image_size(32, 32);
  options.window = RasterWindow{0, 0, kFar + 1, 64};
  EXPECT_EQ(painted(picture, options).code, StatusCode::limit);
  options.window = RasterWindow{kFar - 32, kFar - 32, kFar, kFar};
  EXPECT_TRUE(painted(picture, options).ok());
  Limits limits;
  limits.image_side = 31;
  const Status status = painted(picture, options, limits);
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.limit, "image-side");
}

TEST(RasterWindows, leave_what_lies_between_rows_alone) {
  const Picture picture = two_halves(700, 350);
  RasterOptions options = image_size(300, 50, PixelFormat::rgb8);
  options.window = RasterWindow{201, 33, 700, 700};
  Context context;
  const Image image = rasterized(picture, options);
  constexpr std::size_t kRowBytes = 911;
  std::vector<std::uint8_t> pixels(kRowBytes * 50 + 7, 0xa5);
  ASSERT_TRUE(rasterize_into(context, picture, options, pixels.data() + 7, kRowBytes).ok());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t row = (i - 7) / kRowBytes, at = (i - 7) % kRowBytes;
    const bool is_between = i < 7 || at >= 900;
    ASSERT_EQ(pixels[i], is_between ? 0xa5 : image.bytes[900 * row + at]) << i;
  }
}

TEST(RasterWindows, want_memory_for_their_pixels) {
  const Picture picture = two_halves(64, 32);
  const RasterOptions options = image_size(32, 32, PixelFormat::rgba16);
  std::vector<std::uint8_t> pixels(256 * 32);
  Context context;
  EXPECT_EQ(rasterize_into(context, picture, options, nullptr, 256).code, StatusCode::bad_input);
  EXPECT_EQ(rasterize_into(context, picture, options, pixels.data(), 255).code,
            StatusCode::bad_input);
  EXPECT_TRUE(rasterize_into(context, picture, options, pixels.data(), 256).ok());
  // A single row has no next one.
  const RasterOptions row = image_size(32, 1, PixelFormat::rgba16);
  EXPECT_TRUE(rasterize_into(context, picture, row, pixels.data(), std::size_t{1} << 58).ok());
}

/// Curves that touch the borders of tiles, from either side.
TEST(RasterWindows, of_curves_on_the_borders_of_tiles_have_the_bytes_of_the_whole) {
  Context context;
  for (const double at : {255.0, 256.0, 257.0, 511.99999999999994, 512.0, 512.5}) {
    RegionMesh mesh = jittered_grid({{0, 0}, {1024, 512}}, 16, 3,
                                    [](int column, int row) { return (column + row) % 2; });
    for (Vec2& p : mesh.vertex)
      p = {std::round(p.x / 64) * 64 + at - 256, std::round(p.y / 32) * 32};
    Picture picture = make_picture(make_layer(mesh, [](int region, Vec2 p) {
      return Rgb{static_cast<float>(0.3 + p.x / 3000), region == 0 ? 0.2f : 0.8f, 0.5f};
    }));
    picture.viewport = {{0, 0}, {1024, 512}};
    const RasterOptions options = image_size(1024, 512);
    const Image whole = rasterized(picture, options);
    for (const Cut& cut : {Cut{256, 64}, Cut{256, 256}, Cut{100, 70, -3, -5}}) {
      expect_same_pixels(painted_in_windows(context, picture, options, cut), whole,
                         std::to_string(at));
      expect_same_pixels(painted_prepared(context, picture, options, cut), whole,
                         std::to_string(at));
    }
  }
}

/// The overlapping pixels of two windows of a huge image.
TEST(RasterWindows, far_from_the_corner_show_the_same_where_they_overlap) {
  Picture picture = two_halves(1, 0.75 + 1.0 / (3 << 20));
  LocalStroke stroke;
  stroke.curve.control_points = {{0.75, 0.5}, {0.75, 0.75}, {0.7500003, 0.8}, {0.75, 1}};
  stroke.curve.left_color.stops = {{0, {1, 1, 0}}};
  stroke.curve.right_color.stops = {{0, {0, 1, 0}}};
  stroke.curve.influence_radius.stops = {{0, 0.000002f}};
  picture.stack.push_back(stroke);
  RasterOptions options = image_size(300, 200);
  constexpr int kCornerX = kFar / 4 * 3 - 150, kCornerY = kFar / 4 * 3 - 100;
  options.window = RasterWindow{kCornerX, kCornerY, kFar, kFar};
  const Image first = rasterized(picture, options);
  options.window = RasterWindow{kCornerX + 33, kCornerY + 21, kFar, kFar};
  const Image second = rasterized(picture, options);
  int colors = 0;
  for (int y = 0; y < 179; ++y) {
    for (int x = 0; x < 267; ++x) {
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(channel(first, x + 33, y + 21, c), channel(second, x, y, c)) << x << ' ' << y;
      colors += channel(second, x, y, 0) != channel(second, 0, 0, 0);
    }
  }
  EXPECT_GT(colors, 10'000) << "the curve and the stroke are to be seen";
}

/// Returns a picture in a huge image, so many tiles right of the corner and below it.
Image placed_far(int tiles, const Picture& picture) {
  RasterOptions options = image_size(600, 150);
  options.window = RasterWindow{256 * tiles, 64 * tiles, kFar, kFar};
  const Vec2 corner{-256.0 * tiles, -64.0 * tiles};
  options.viewport = Box{corner, corner + Vec2{1.0 * kFar, 1.0 * kFar}};
  return rasterized(picture, options);
}

/// Gradients, textures and strokes are as precise there as near the corner.
TEST(RasterWindows, far_from_the_corner_show_what_they_do_near_it) {
  const Box box{{0, 0}, {600, 150}};
  const RegionMesh mesh = jittered_grid(box, 20, 5, [](int column, int) { return column / 7 % 2; });
  PatchLayer layer = make_layer(mesh, [](int region, Vec2 p) {
    return region == 0 ? Rgb{0.2f, static_cast<float>(p.x / 700), 0.9f} : Rgb{0.9f, 0.6f, 0};
  });
  add_weight(
      mesh, 0, [](int, Vec2 p) { return static_cast<float>(p.y / 400); }, &layer.color);
  add_weight(
      mesh, 1, [](int, Vec2 p) { return static_cast<float>(p.x / 1500); }, &layer.color);
  Picture picture = make_picture(std::move(layer));
  GradientFill fill;
  fill.shape = LinearGradient{{3, 4}, {61, 40}};
  fill.spread = SpreadMethod::repeat;
  fill.stops = {{0, {1, 0, 0}, 1}, {0.6, {0, 1, 1}, 1}, {1, {0, 0, 0}, 0.5f}};
  Texture texture;
  texture.width = texture.height = 8;
  for (int i = 0; i < 64; ++i)
    for (int c = 0; c < 4; ++c) texture.rgba.push_back(static_cast<std::uint8_t>(37 * i + 80 * c));
  texture.layer_from_texture = {2.3, 0.4, -0.3, 1.9, 11, 5};
  picture.shaders = {{"lines", fill}, {"cloth", texture}};
  LocalStroke stroke;
  stroke.curve.control_points = {{20, 20}, {200, 300}, {400, -200}, {580, 120}};
  stroke.curve.left_color.stops = {{0, {1, 1, 1}}};
  stroke.curve.right_color.stops = {{0, {0, 0, 0}}, {1, {0, 0.5f, 0}}};
  stroke.curve.influence_radius.stops = {{0, 3}, {1, 20}};
  picture.stack.push_back(stroke);
  const Image near = placed_far(0, picture);
  for (const int tiles : {1, 1000, 60'000}) {
    const Image far = placed_far(tiles, picture);
    int most = 0;
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 600; ++x)
        for (int c = 0; c < 3; ++c)
          most = std::max(most, std::abs(channel(near, x, y, c) - channel(far, x, y, c)));
    EXPECT_LE(most, 4) << "steps of 65,535, " << tiles << " tiles from the corner";
  }
}

TEST(PreparedRasters, refuse_what_rasterize_refuses) {
  Context context;
  const Picture picture = two_halves(64, 32);
  RasterOptions options = image_size(0, 10);
  EXPECT_EQ(PreparedRaster::create(context, picture, options).status().code, StatusCode::bad_input);
  options.width = kFar + 1;
  EXPECT_EQ(PreparedRaster::create(context, picture, options).status().code, StatusCode::limit);
  options.width = 100;
  options.window = RasterWindow{0, 0, 200, 200};
  EXPECT_EQ(PreparedRaster::create(context, picture, options).status().code, StatusCode::bad_input);
  options.window.reset();
  Result<PreparedRaster> prepared = PreparedRaster::create(context, picture, options);
  ASSERT_TRUE(prepared.ok());
  std::vector<std::uint8_t> pixels(6000);
  EXPECT_EQ(prepared->paint(context, 91, 0, 10, 10, pixels.data(), 600).code,
            StatusCode::bad_input);
  EXPECT_EQ(prepared->paint(context, 0, 0, 0, 10, pixels.data(), 600).code, StatusCode::bad_input);
  EXPECT_EQ(prepared->paint(context, 0, 0, 10, 10, nullptr, 600).code, StatusCode::bad_input);
  context.cancel = true;
  EXPECT_EQ(prepared->paint(context, 0, 0, 10, 10, pixels.data(), 600).code, StatusCode::cancelled);
  context.cancel = false;
  EXPECT_TRUE(prepared->paint(context, 90, 0, 10, 10, pixels.data(), 600).ok());
  const PreparedRaster taken = std::move(*prepared);
  EXPECT_TRUE(taken.paint(context, 0, 0, 10, 10, pixels.data(), 600).ok());
}

TEST(PreparedRasters, give_their_memory_back) {
  Context context;
  const Picture picture = two_halves(64, 32);
  {
    const Result<PreparedRaster> prepared =
        PreparedRaster::create(context, picture, image_size(100, 100));
    ASSERT_TRUE(prepared.ok());
    EXPECT_GT(context.budget.used(), 0u);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::test
