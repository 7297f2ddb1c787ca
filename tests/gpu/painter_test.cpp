#include "gpu/painter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "raster/layers/layer_view.hpp"
#include "raster/pictures.hpp"
#include "support.hpp"

namespace sfumato::gpu {
namespace {

constexpr int kWidth = 64, kHeight = 48;
const Box kPaintedBox{{0, 0}, {kWidth, kHeight}};

/// Returns a wave under its mirror image, both in code values, and a local curve.
Picture layered_picture() {
  const test::RegionMesh mesh =
      test::jittered_grid(kPaintedBox, 5, 3, [](int x, int y) { return x ^ y; });
  Picture picture = test::make_picture(test::make_layer(mesh, [](int region, Vec2 p) {
    const auto value = static_cast<float>(0.5 + 0.3 * std::sin(0.1 * p.x - 0.2 * p.y + region));
    return Rgb{value, 1 - value, 0.5f + 0.5f * value};
  }));
  picture.stack.push_back(PatchInstance{0, {-1, 0, 0, 1, kWidth, 0}, 0.5f, BlendMode::soft_light});
  LocalStroke stroke;
  stroke.curve.control_points = {{5, 8}, {40, 2}, {20, 50}, {60, 40}};
  stroke.curve.left_color.stops = {{0, {1, 0.5f, 0}}};
  stroke.curve.influence_radius.stops = {{0, 6}};
  picture.stack.push_back(stroke);
  return picture;
}

/// Returns the largest difference to rasterize(), in code values of 255.
double worst_difference(bool single_precision) {
  const Picture picture = layered_picture();
  const RasterOptions options = test::image_size(kWidth, kHeight);
  const Image expected = test::rasterized(picture, options);
  Context context;
  const auto device = Device::create();
  const Result<Affine> map = raster::image_from_artboard(picture, options);
  const PixelRect whole{0, 0, kWidth, kHeight};
  const Result<DrawList> list = DrawList::create(context, **device, picture, *map, whole, false);
  EXPECT_TRUE(list.ok()) << to_string(list.status());
  PaintSettings settings;
  settings.tile_width = kWidth;
  settings.tile_height = kHeight;
  settings.single_precision = single_precision;
  Result<Painter> painter = Painter::create(context, **device, *list, settings);
  EXPECT_TRUE(painter.ok()) << to_string(painter.status());
  std::vector<float> rgba(4 * kWidth * kHeight);
  const Status status = painter->paint(whole, rgba.data());
  EXPECT_TRUE(status.ok()) << to_string(status);
  double worst = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double value = 255.0 * rgba[static_cast<std::size_t>(4 * (y * kWidth + x) + c)];
        worst = std::max(worst, std::abs(value - test::code_value(expected, x, y, c)));
      }
    }
  }
  return worst;
}

TEST(GpuPainter, single_precision_is_within_a_twentieth_of_a_code_value) {
  SFUMATO_NEEDS_GPU();
  if (!(*Device::create())->blends_floats()) GTEST_SKIP() << "this device blends 16 bits only";
  EXPECT_LT(worst_difference(true), 0.05);
}

TEST(GpuPainter, half_precision_is_within_one_code_value) {
  SFUMATO_NEEDS_GPU();
  EXPECT_LT(worst_difference(false), 1);
}

}  // namespace
}  // namespace sfumato::gpu
