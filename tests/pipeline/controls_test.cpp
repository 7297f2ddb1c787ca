#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "sfumato/api/render_pixels.hpp"
#include "sfumato/raster/rasterize.hpp"
#include "sfumato/solve/diffuse.hpp"
#include "support/drawing.hpp"

// The artistic controls from document to pixels: results known in closed form, and the sparse
// picture compared with the gather at every pixel.
namespace sfumato {
namespace {

using test::blurred;
using test::circle_curve;
using test::colored;
using test::one_layer;
using test::straight_curve;
using test::with_opacity;

constexpr int kSide = 100;

RasterOptions raster_options() {
  RasterOptions options;
  options.width = options.height = kSide;
  return options;
}

Image drawn(const Document& document, RasterOptions options = raster_options()) {
  Context context;
  const Result<Picture> picture = diffuse(context, document, {});
  EXPECT_TRUE(picture.ok()) << picture.status().message;
  Result<Image> image = rasterize(context, *picture, options);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return std::move(*image);
}

Image drawn_at_every_pixel(const Document& document) {
  Context context;
  RasterOptions options = raster_options();
  options.antialias = false;
  Result<Image> image = render_pixels(context, document, {}, options);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return std::move(*image);
}

int channel(const Image& image, int x, int y, int c) {
  const auto channels = static_cast<std::size_t>(channel_count(image.format));
  return image.bytes[(static_cast<std::size_t>(y) * kSide + x) * channels + c];
}

/// Returns how many bytes of two images differ by more than `tolerance`.
int differing(const Image& a, const Image& b, int tolerance) {
  int count = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) {
    count += std::abs(int{a.bytes[i]} - int{b.bytes[i]}) > tolerance;
  }
  return count;
}

Curve imaged(Curve curve) {
  curve.left.color = curve.right.color = {ShaderKind::image_domain, {}, 0};
  return curve;
}

/// Returns a texture with one texel per pixel of the artboard, all of them different.
Texture fine_texture() {
  Texture texture{kSide, kSide, std::vector<std::uint8_t>(4 * kSide * kSide), {}, true, {}, {}};
  for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
    texture.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : (i * 2654435761u) >> 13);
  }
  return texture;
}

TEST(Controls, a_texture_on_both_sides_of_a_line_is_the_texture) {
  for (float radius : {0.0f, 15.0f}) {
    Document document = one_layer({blurred(imaged(straight_curve({20, 30}, {70, 60})), radius)});
    const Texture texture = fine_texture();
    document.shaders.push_back({"texture", texture});
    const Image image = drawn(document);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        for (int c = 0; c < 3; ++c) {
          const int texel = texture.rgba[(static_cast<std::size_t>(y) * kSide + x) * 4 + c];
          ASSERT_NEAR(channel(image, x, y, c), texel, 1) << x << " " << y;
        }
      }
    }
  }
}

TEST(Controls, a_uniform_opacity_mixes_with_the_background) {
  Document document = one_layer(
      {with_opacity(colored(circle_curve({50, 50}, 400), {}, {0.8f, 0.4f, 0}), 0.5f, 0.5f)});
  document.background = Rgb{0, 0.4f, 1};
  const Image image = drawn(document);
  const int expected[] = {102, 102, 128};
  for (int x = 3; x < kSide; x += 7) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(channel(image, x, 99 - x, c), expected[c], 1);
  }
}

TEST(Controls, a_transparent_png_keeps_colour_and_opacity_apart) {
  Document document = one_layer(
      {with_opacity(colored(circle_curve({50, 50}, 400), {}, {0.8f, 0.4f, 0}), 0, 0.25f)});
  RasterOptions options = raster_options();
  options.format = PixelFormat::rgba8;
  const Image image = drawn(document, options);
  const int expected[] = {204, 102, 0, 64};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(channel(image, 33, 71, c), expected[c], 1);
}

TEST(Controls, the_order_of_layers_is_the_order_of_painting) {
  Document document = one_layer({colored(circle_curve({50, 50}, 400), {}, test::kRed)});
  document.layers.push_back({"blue", {colored(circle_curve({50, 50}, 400), {}, test::kBlue)}});
  document.stack.push_back(LayerInstance{1, {}});
  EXPECT_EQ(channel(drawn(document), 50, 50, 2), 255);
  std::swap(document.stack[0], document.stack[1]);
  EXPECT_EQ(channel(drawn(document), 50, 50, 0), 255);
}

TEST(Controls, an_instance_is_the_transformed_layer) {
  const auto fish = [](const Affine& map) {
    std::vector<Curve> curves{
        blurred(with_opacity(circle_curve({20, 15}, 12), 0, 1), 3),
        colored(straight_curve({10, 15}, {30, 17}), {1, 0.6f, 0}, {0.9f, 0.9f, 0.5f})};
    for (Curve& curve : curves) {
      for (Vec2& p : curve.control_points) p = map(p);
    }
    return curves;
  };
  const double scale = 2.1;
  const Affine turn{0.8 * scale, 0.6 * scale, -0.6 * scale, 0.8 * scale, 25, 5};
  Document transformed = one_layer(fish({}));
  std::get<LayerInstance>(transformed.stack[0]).artboard_from_layer = turn;
  Document drawn_there = one_layer(fish(turn));
  for (Side* side :
       {&drawn_there.layers[0].curves[0].left, &drawn_there.layers[0].curves[0].right}) {
    side->blur_radius.stops[0].value *= static_cast<float>(scale);
  }
  EXPECT_LE(differing(drawn(transformed), drawn(drawn_there), 2), 3 * kSide * kSide / 500);
}

TEST(Controls, the_axis_of_a_local_curve_is_as_opaque_as_its_alpha) {
  Document document;
  document.artboard = {{0, 0}, {kSide, kSide}};
  document.background = test::kWhite;
  LocalCurve curve;
  curve.control_points = straight_curve({-200, 50.5}, {300, 50.5}).control_points;
  curve.left_color = curve.right_color = test::one_color(test::kBlack).stops;
  curve.influence_radius = {StopSpace::parameter, {{0, 20.0f}}};
  curve.alpha = 0.6;
  document.stack.push_back(LocalStroke{curve, {}});
  const Image image = drawn(document);
  EXPECT_NEAR(channel(image, 40, 50, 0), 255 * 0.4, 1);
  EXPECT_EQ(channel(image, 40, 71, 0), 255);
}

/// Returns a document with every control.
Document busy_document(InterpolationSpace space) {
  Document document = one_layer(
      {blurred(colored(circle_curve({45, 50}, 28), {0.9f, 0.8f, 0.2f}, {0.1f, 0.3f, 0.7f}), 6),
       imaged(straight_curve({5, 90}, {60, 95}))});
  document.interpolation = space;
  document.background = Rgb{0.5f, 0.5f, 0.5f};
  GradientFill sky{LinearGradient{{0, 0}, {0, 100}}, SpreadMethod::pad, {}, {}};
  sky.stops = {{0, {0.2f, 0.5f, 0.9f}, 1}, {1, {0.9f, 0.7f, 0.6f}, 1}};
  document.shaders.push_back({"sky", sky});
  document.layers.push_back({"fish",
                             {blurred(with_opacity(circle_curve({0, 0}, 15), 0, 0.9f), 4),
                              colored(straight_curve({-9, 0}, {9, 2}), test::kRed, test::kGreen)}});
  document.stack.push_back(GroupBegin{0.7f, BlendMode::multiply});
  document.stack.push_back(LayerInstance{1, {1, 0, 0, 1, 65, 40}});
  document.stack.push_back(
      LayerInstance{1, {-0.8, 0.5, 0.5, 0.8, 40, 65}, 0.8f, BlendMode::screen});
  document.stack.push_back(GroupEnd{});
  return document;
}

TEST(Controls, the_sparse_picture_is_near_the_gather_at_every_pixel) {
  for (auto space :
       {InterpolationSpace::srgb, InterpolationSpace::linear, InterpolationSpace::oklab}) {
    const Document document = busy_document(space);
    const Image sparse = drawn(document), exact = drawn_at_every_pixel(document);
    // Pixels that sharp curves cut are antialiased in only one of the two.
    EXPECT_LE(differing(sparse, exact, 2), 3 * 150);
    EXPECT_LE(differing(sparse, exact, 60), 3 * 40);
  }
}

}  // namespace
}  // namespace sfumato
