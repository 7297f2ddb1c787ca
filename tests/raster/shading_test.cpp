#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "raster/pictures.hpp"
#include "raster/support.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::test {
namespace {

constexpr Box kShadedBox{{0, 0}, {8, 8}};
constexpr int kWidth = 96, kHeight = 80;

Shader constant_shader(const Rgb& color, float alpha = 1) {
  GradientFill fill;
  fill.stops = {{0, color, alpha}, {1, color, alpha}};
  return {"constant", fill};
}

/// Returns a ramp from (0, 0) to (8, 0) of the layer frame.
Shader ramp_shader(const Rgb& from, const Rgb& to) {
  GradientFill fill;
  fill.shape = LinearGradient{{0, 0}, {8, 0}};
  fill.stops = {{0, from, 1}, {1, to, 1}};
  return {"ramp", fill};
}

/// Returns 8 × 8 texels, one per unit of the layer, of hashed colours.
Shader checkered_texture() {
  Texture texture;
  texture.width = texture.height = 8;
  for (std::uint32_t i = 0; i < 64; ++i) {
    for (std::uint32_t c = 0; c < 3; ++c)
      texture.rgba.push_back(static_cast<std::uint8_t>((i * 3 + c) * 2654435761u >> 24));
    texture.rgba.push_back(255);
  }
  return {"texture", texture};
}

Rgb black(int, Vec2) {
  return {};
}

Image shaded(const Picture& picture, PixelFormat format = PixelFormat::rgba16) {
  return rasterized(picture, image_size(kWidth, kHeight, format));
}

/// Returns the largest difference in steps of 16 bits, over all channels.
int worst_difference(const Image& a, const Image& b) {
  int worst = 0;
  for (int i = 0; i < a.width * a.height * channel_count(a.format); ++i) {
    const int c = i % channel_count(a.format), x = i / channel_count(a.format) % a.width;
    const int y = i / channel_count(a.format) / a.width;
    worst = std::max(worst, std::abs(channel(a, x, y, c) - channel(b, x, y, c)));
  }
  return worst;
}

/// Returns a varying weight, 0.2 to 0.8.
float share(int region, Vec2 p) {
  return static_cast<float>(0.5 + 0.3 * std::sin(p.x + 2 * p.y + region));
}

TEST(RasterShading, weights_that_sum_to_1_of_one_constant_colour_give_that_colour) {
  const Rgb color{0.3f, 0.65f, 0.9f};
  const RegionMesh mesh = jittered_grid(kShadedBox, 6, 5, [](int i, int j) { return i * j % 3; });
  for (InterpolationSpace space :
       {InterpolationSpace::srgb, InterpolationSpace::linear, InterpolationSpace::oklab}) {
    const Rgb own = from_srgb(space, color);
    PatchLayer layer = make_layer(
        mesh, [&](int region, Vec2 p) { return lerp(Rgb{}, own, 1 - share(region, p)); });
    add_weight(
        mesh, 0, [](int region, Vec2 p) { return 0.25f * share(region, p); }, &layer.color);
    add_weight(
        mesh, 1, [](int region, Vec2 p) { return 0.75f * share(region, p); }, &layer.color);
    Picture picture = make_picture(layer);
    picture.interpolation = space;
    picture.shaders = {constant_shader(color), constant_shader(color)};
    const Image image = shaded(picture);
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const int x = i % kWidth, y = i / kWidth;
      ASSERT_NEAR(channel(image, x, y, 0), 65535 * color.r, 2);
      ASSERT_NEAR(channel(image, x, y, 1), 65535 * color.g, 2);
      ASSERT_NEAR(channel(image, x, y, 2), 65535 * color.b, 2);
      ASSERT_EQ(channel(image, x, y, 3), 65535);
    }
  }
}

TEST(RasterShading, a_gradient_with_weight_1_is_the_gradient_at_every_pixel) {
  const RegionMesh mesh = jittered_grid(kShadedBox, 3, 2);
  PatchLayer layer = make_layer(mesh, black);
  add_weight(
      mesh, 0, [](int, Vec2) { return 1.0f; }, &layer.color);
  Picture picture = make_picture(layer);
  picture.shaders = {ramp_shader({1, 0, 0.2f}, {0, 1, 0.6f})};
  const Image image = shaded(picture);
  for (int x = 0; x < kWidth; ++x) {
    const double t = (x + 0.5) / kWidth;
    EXPECT_NEAR(channel(image, x, 31, 0), 65535 * (1 - t), 3);
    EXPECT_NEAR(channel(image, x, 31, 1), 65535 * t, 3);
    EXPECT_NEAR(channel(image, x, 31, 2), 65535 * (0.2 + 0.4 * t), 3);
  }
}

TEST(RasterShading, a_texture_on_both_sides_of_a_curve_is_the_texture) {
  const auto one = [](int, Vec2) { return 1.0f; };
  const RegionMesh whole = jittered_grid(kShadedBox, 1, 2);
  PatchLayer plain = make_layer(whole, black);
  add_weight(whole, 0, one, &plain.color);
  const RegionMesh cut = cut_box(kShadedBox, {3.3, 8}, {4.9, 0});
  PatchLayer divided = make_layer(cut, black);
  add_weight(cut, 0, one, &divided.color);
  Picture a = make_picture(plain), b = make_picture(divided);
  a.shaders = b.shaders = {checkered_texture()};
  const Image left = shaded(a), right = shaded(b);
  // A pixel that the curve cuts is the mean of the texture at two centroids.
  int different = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int x = i % kWidth, y = i / kWidth;
    const double curve_x = lerp(cut.vertex[1], cut.vertex[2], (y + 0.5) / kHeight).x / 8 * kWidth;
    for (int c = 0; c < 4; ++c) {
      const int difference = std::abs(channel(left, x, y, c) - channel(right, x, y, c));
      const bool is_far = std::fabs(x + 0.5 - curve_x) > 2;
      ASSERT_LE(difference, is_far ? 1 : 65535) << x << ' ' << y;
      different += difference > 6000;
    }
  }
  EXPECT_LT(different, 20);
}

TEST(RasterShading, a_textured_instance_equals_the_textured_layer_moved) {
  const RegionMesh mesh = jittered_grid({{-3, -3}, {3, 3}}, 4, 4);
  PatchLayer layer = make_layer(mesh, black);
  add_weight(mesh, 0, share, &layer.color);
  Picture instance = make_picture(layer);
  instance.viewport = kShadedBox;
  instance.shaders = {checkered_texture()};
  const Affine map{0.6, 0.3, -0.31, 0.57, 4.013, 3.97};
  std::get<PatchInstance>(instance.stack[0]).artboard_from_layer = map;
  Picture moved = instance;
  std::get<PatchInstance>(moved.stack[0]).artboard_from_layer = {};
  for (Vec2& p : moved.layers[0].vertex_position) p = map(p);
  std::get<Texture>(moved.shaders[0].paint).layer_from_texture = map;
  EXPECT_LE(worst_difference(shaded(instance), shaded(moved)), 20);
}

TEST(RasterShading, each_of_nine_shaders_counts_with_its_own_weight) {
  const RegionMesh mesh = jittered_grid(kShadedBox, 5, 3);
  PatchLayer layer = make_layer(mesh, black);
  Picture picture = make_picture({});
  Rgb expected;
  for (std::uint32_t s = 0; s < 9; ++s) {
    const float weight = 0.02f * static_cast<float>(s + 1);
    const Rgb color{s % 3 == 0 ? 1.0f : 0.1f, s % 3 == 1 ? 0.9f : 0.0f,
                    0.1f * static_cast<float>(s)};
    // The shaders of a layer need not follow the picture's order.
    picture.shaders.insert(picture.shaders.begin(), constant_shader(color));
    add_weight(
        mesh, 8 - s, [&](int, Vec2) { return weight; }, &layer.color);
    expected = {expected.r + weight * color.r, expected.g + weight * color.g,
                expected.b + weight * color.b};
  }
  picture.layers = {layer};
  picture.viewport = picture.artboard = kShadedBox;
  const Image image = shaded(picture);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int x = i % kWidth, y = i / kWidth;
    ASSERT_NEAR(channel(image, x, y, 0), 65535 * expected.r, 2);
    ASSERT_NEAR(channel(image, x, y, 1), 65535 * expected.g, 2);
    ASSERT_NEAR(channel(image, x, y, 2), 65535 * expected.b, 2);
  }
}

TEST(RasterShading, an_opacity_shader_gives_alpha_times_luminance) {
  const RegionMesh mesh = jittered_grid(kShadedBox, 3, 2);
  const Rgb color{0.9f, 0.4f, 0.2f};
  for (InterpolationSpace space : {InterpolationSpace::srgb, InterpolationSpace::oklab}) {
    PatchLayer layer = make_layer(mesh, black);
    set_opacity(
        mesh, [](int, Vec2) { return 0.1f; }, &layer);
    add_weight(
        mesh, 0, [](int, Vec2) { return 0.75f; }, &layer.opacity);
    Picture picture = make_picture(layer);
    picture.interpolation = space;
    picture.shaders = {constant_shader(color, 0.8f)};
    const double luminance = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
    EXPECT_NEAR(channel(shaded(picture), 50, 40, 3), 65535 * (0.1 + 0.75 * 0.8 * luminance), 3);
  }
}

TEST(RasterShading, a_mask_by_a_shader_has_no_fringe) {
  // Red where the mask is white, blue where it is black.
  const RegionMesh mesh = cut_box(kShadedBox, {3.3, 8}, {4.9, 0});
  PatchLayer layer = make_layer(mesh, [](int region, Vec2) {
    return region ? Rgb{0, 0, 1} : Rgb{1, 0, 0};
  });
  set_opacity(
      mesh, [](int, Vec2) { return 0.0f; }, &layer);
  add_weight(
      mesh, 0, [](int region, Vec2) { return region ? 0.0f : 1.0f; }, &layer.opacity);
  add_weight(
      mesh, 1, [](int region, Vec2) { return region ? 1.0f : 0.0f; }, &layer.opacity);
  Picture picture = make_picture(layer);
  picture.shaders = {constant_shader({1, 1, 1}), constant_shader({0, 0, 0})};
  const Image image = shaded(picture);
  int partial = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int x = i % kWidth, y = i / kWidth;
    const int alpha = channel(image, x, y, 3);
    partial += alpha > 0 && alpha < 65535;
    ASSERT_GE(channel(image, x, y, 0), alpha > 0 ? 65535 - 2 : 0);
    ASSERT_EQ(channel(image, x, y, 2), 0);
  }
  EXPECT_GT(partial, 40);
}

TEST(RasterShading, shaders_give_the_same_bytes_for_any_instruction_set_and_crop) {
  const RegionMesh mesh = jittered_grid(kShadedBox, 7, 3, [](int i, int j) { return i * j % 3; });
  PatchLayer layer = make_layer(mesh, [](int region, Vec2 p) {
    return lerp(Rgb{0.1f, 0.2f, 0.3f}, Rgb{0.9f, 0.2f, 0.1f}, share(region, p));
  });
  for (std::uint32_t s = 0; s < 5; ++s) {
    const auto weight = [&](int region, Vec2 p) {
      return region == 1 ? 0 : 0.2f * share(static_cast<int>(s), p);
    };
    add_weight(mesh, s % 3, weight, &layer.color);
  }
  set_opacity(mesh, share, &layer);
  add_weight(mesh, 1, share, &layer.opacity);
  Picture picture = make_picture(layer);
  picture.shaders = {checkered_texture(), ramp_shader({1, 0, 0}, {0, 1, 0.5f}),
                     constant_shader({0.2f, 0.4f, 0.6f}, 0.5f)};
  for (InterpolationSpace space : {InterpolationSpace::srgb, InterpolationSpace::oklab}) {
    picture.interpolation = space;
    expect_same_for_every_instruction_set(picture, image_size(313, 201, PixelFormat::rgba16));
  }
}

}  // namespace
}  // namespace sfumato::test
