// Layers whose pixels show exact fields.
#include "picture/point_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "sfumato/raster/rasterize.hpp"
#include "support/windows.hpp"

namespace sfumato {
namespace {

constexpr int kWidth = 300, kHeight = 100;  // two tiles beside each other, two rows

/// A field of a colour at each point; counts the points.
class Painted final : public picture::PointFields {
 public:
  using Paint = std::function<Rgb(Vec2)>;

  Painted(Paint paint, float max_miss, Status status = {})
      : paint_(std::move(paint)), max_miss_(max_miss), status_(std::move(status)) {}

  Status read(Context&, std::span<const Vec2> points, std::span<const std::uint32_t> group_end,
              picture::PointValues* values) const override {
    values->color.clear();
    for (const Vec2 point : points) {
      const Rgb color = paint_(point);
      values->color.insert(values->color.end(), {color.r, color.g, color.b});
    }
    values->opacity.clear();
    values->hit.assign(points.size(), 1);
    EXPECT_EQ(group_end.empty() ? 0 : group_end.back(), points.size());
    EXPECT_TRUE(std::ranges::is_sorted(group_end));
    count_ += points.size();
    return status_;
  }
  float max_miss() const override { return max_miss_; }
  std::size_t bytes() const override { return 1000; }
  std::uint64_t read_count() const override { return count_; }

 private:
  Paint paint_;
  float max_miss_;
  Status status_;
  mutable std::atomic<std::uint64_t> count_{0};
};

/// Returns a layer over the whole picture, parted by a line from (x, 0) to (x + lean, height).
/// Takes over the fields.
Picture halves(const Painted* fields, double x, double lean) {
  Picture picture;
  picture.for_pixel_grid = true;
  picture.artboard = picture.viewport = {{0, 0}, {kWidth, kHeight}};
  PatchLayer layer;
  layer.frame = picture.artboard;
  layer.vertex_position = {{0, 0},       {x, 0},      {x + lean, kHeight},
                           {0, kHeight}, {kWidth, 0}, {kWidth, kHeight}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
  layer.edge_is_curve = {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  layer.color = {3, {}, {}, {}};
  layer.exact_points = PointFieldsRef(fields);
  picture.layers = {layer};
  picture.stack = {PatchInstance{}};
  return picture;
}

RasterOptions size() {
  RasterOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.format = PixelFormat::rgb16;
  return options;
}

Image drawn(const Picture& picture, const RasterOptions& options = size()) {
  Context context;
  Result<Image> image = rasterize(context, picture, options);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image ? std::move(*image) : Image{};
}

/// Returns the red of a pixel of a 16-bit image, from 0 to 1.
double red(const Image& image, int x, int y) {
  std::uint16_t value;
  std::memcpy(&value, image.bytes.data() + std::size_t{6} * (kWidth * y + x), sizeof(value));
  return value / 65535.0;
}

Rgb slope(Vec2 p) {
  return {static_cast<float>(p.x / kWidth), static_cast<float>(p.y / kHeight), 0.5f};
}

/// Returns a pattern that no neighbour tells.
Rgb noise(Vec2 p) {
  const double wave = std::sin(12.9898 * p.x + 78.233 * p.y) * 43758.5453;
  return {static_cast<float>(wave - std::floor(wave)), 0, 0};
}

TEST(PointFields, every_pixel_has_the_value_of_its_centre_where_no_miss_is_allowed) {
  auto* const fields = new Painted(noise, 0.0f);
  const Picture picture = halves(fields, 150, 0);
  const Image image = drawn(picture);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_NEAR(red(image, x, y), noise({x + 0.5, y + 0.5}).r, 1.0 / 65535) << x << ' ' << y;
  EXPECT_EQ(fields->read_count(), std::size_t{kWidth} * kHeight);
}

TEST(PointFields, a_slope_is_interpolated_from_few_points) {
  auto* const fields = new Painted(slope, 0.001f);
  const Picture picture = halves(fields, 150, 0);
  const Image image = drawn(picture);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_NEAR(red(image, x, y), (x + 0.5) / kWidth, 2.0 / 65535) << x << ' ' << y;
  EXPECT_LT(fields->read_count(), std::size_t{kWidth} * kHeight / 8);
}

TEST(PointFields, a_field_that_bends_everywhere_is_read_everywhere) {
  auto* const fields = new Painted(noise, 1e-6f);
  const Picture picture = halves(fields, 150, 0);
  const Image image = drawn(picture);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_NEAR(red(image, x, y), noise({x + 0.5, y + 0.5}).r, 1.0 / 65535) << x << ' ' << y;
}

TEST(PointFields, a_smooth_bump_is_found) {
  const auto bump = [](Vec2 p) {
    const Vec2 d = p - Vec2{70.3, 41.7};
    return Rgb{static_cast<float>(std::exp(-length_squared(d) / 200)), 0, 0};
  };
  constexpr float kMiss = 0.5f / 255;
  auto* const fields = new Painted(bump, kMiss);
  const Picture picture = halves(fields, 150, 0);
  const Image image = drawn(picture);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_NEAR(red(image, x, y), bump({x + 0.5, y + 0.5}).r, 3 * kMiss) << x << ' ' << y;
  EXPECT_LT(fields->read_count(), std::size_t{kWidth} * kHeight / 2);
}

TEST(PointFields, a_pixel_on_a_curve_has_the_mean_of_both_sides) {
  // The field jumps at the curve, which leans from 150 to 160.
  const auto sides = [](Vec2 p) {
    return Rgb{p.x - 150 - 10 * p.y / kHeight > 0 ? 1.0f : 0.0f, 0, 0};
  };
  const Image image = drawn(halves(new Painted(sides, 0.001f), 150, 10));
  for (int y = 0; y < kHeight; ++y) {
    double sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += red(image, x, y);
    EXPECT_NEAR(sum, kWidth - 150 - 10 * (y + 0.5) / kHeight, 1e-3) << y;
  }
}

TEST(PointFields, without_antialiasing_centres_decide) {
  const auto sides = [](Vec2 p) { return Rgb{p.x > 150.4 ? 1.0f : 0.0f, 0, 0}; };
  RasterOptions options = size();
  options.antialias = false;
  const Image image = drawn(halves(new Painted(sides, 0.0f), 150.4, 0), options);
  EXPECT_EQ(red(image, 149, 5), 0);
  EXPECT_EQ(red(image, 150, 5), 1);
}

TEST(PointFields, windows_and_threads_change_no_byte) {
  const Picture picture = halves(new Painted(slope, 0.001f), 150, 17);
  Context context;
  const Image whole = drawn(picture);
  const test::Cut cut{23, 17, -5, -3};
  EXPECT_EQ(test::painted_in_windows(context, picture, size(), cut).bytes, whole.bytes);
}

TEST(PointFields, their_failure_is_the_answer) {
  Context context;
  const Status broken = make_error(StatusCode::limit, "no more");
  const Picture picture = halves(new Painted(slope, 0.001f, broken), 150, 0);
  const Result<Image> image = rasterize(context, picture, size());
  EXPECT_EQ(image.status().code, StatusCode::limit);
  EXPECT_EQ(image.status().message, "no more");
}

TEST(PointFields, a_layer_with_nodes_besides_is_refused) {
  Context context;
  Picture picture = halves(new Painted(slope, 0.001f), 150, 0);
  picture.layers[0].color.node_value = {0, 0, 0};
  EXPECT_EQ(rasterize(context, picture, size()).status().code, StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato
