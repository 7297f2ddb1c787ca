// Fields that do not come from patches.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "raster/rasterize_source.hpp"

namespace sfumato {
namespace {

constexpr int kSourceSide = 8;

/// One colour and half the opacity everywhere; its tables lack `missing` values.
class EvenSource final : public picture::FieldSource {
 public:
  explicit EvenSource(std::size_t missing = 0, Status status = {})
      : missing_(missing), status_(std::move(status)) {}

  Status read(std::uint32_t, const Affine&, const PixelRect& rect,
              picture::FieldPixels* out) const override {
    const auto count = static_cast<std::size_t>(rect.x1 - rect.x0) * (rect.y1 - rect.y0);
    out->color.clear();
    for (std::size_t i = 0; i < count; ++i) {
      out->color.insert(out->color.end(), {1.0f, 0.5f, 0.0f});
    }
    out->opacity.assign(count, 0.5f);
    out->hit.assign(count, 1);
    if (missing_ == 1) out->color.pop_back();
    if (missing_ == 2) out->opacity.pop_back();
    if (missing_ == 3) out->hit.pop_back();
    return status_;
  }

 private:
  std::size_t missing_;
  Status status_;
};

PatchField field_of(int channels) {
  return {channels,
          std::vector<std::uint32_t>(2 * kNodesPerTriangle, 0),
          std::vector<float>(static_cast<std::size_t>(channels), 0.0f),
          {}};
}

/// Returns a layer of two triangles over the whole picture.
Picture two_triangles() {
  Picture picture;
  picture.artboard = picture.viewport = {{0, 0}, {kSourceSide, kSourceSide}};
  PatchLayer layer;
  layer.frame = picture.artboard;
  layer.vertex_position = {{0, 0}, {kSourceSide, 0}, {kSourceSide, kSourceSide}, {0, kSourceSide}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3};
  layer.edge_is_curve.assign(6, 0);
  layer.color = field_of(3);
  layer.opacity = field_of(1);
  picture.layers = {layer};
  picture.stack = {PatchInstance{}};
  return picture;
}

Result<Image> drawn(const Picture& picture, const picture::FieldSource& source) {
  Context context;
  return rasterize(context, picture,
                   {.width = kSourceSide, .height = kSourceSide, .format = PixelFormat::rgba8},
                   source);
}

TEST(FieldSource, its_values_are_the_pixels) {
  const Result<Image> image = drawn(two_triangles(), EvenSource());
  ASSERT_TRUE(image.ok()) << image.status().message;
  for (std::size_t i = 0; i < image->bytes.size(); i += 4) {
    EXPECT_EQ(image->bytes[i], 255);
    EXPECT_NEAR(image->bytes[i + 1], 128, 1);
    EXPECT_EQ(image->bytes[i + 2], 0);
    EXPECT_NEAR(image->bytes[i + 3], 128, 1);
  }
}

TEST(FieldSource, a_layer_without_opacity_is_refused) {
  Picture picture = two_triangles();
  picture.layers[0].opacity = {};
  EXPECT_EQ(drawn(picture, EvenSource()).status().code, StatusCode::bad_input);
}

TEST(FieldSource, tables_that_are_too_short_are_refused) {
  for (const std::size_t missing : {1u, 2u, 3u}) {
    EXPECT_EQ(drawn(two_triangles(), EvenSource(missing)).status().code, StatusCode::bad_input);
  }
}

TEST(FieldSource, its_failure_is_the_answer) {
  const EvenSource failing(0, make_error(StatusCode::io, "no tape"));
  EXPECT_EQ(drawn(two_triangles(), failing).status().message, "no tape");
}

}  // namespace
}  // namespace sfumato
