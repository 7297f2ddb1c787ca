#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "raster/pictures.hpp"
#include "raster/support.hpp"
#include "sfumato/base/color_space.hpp"

namespace sfumato::test {
namespace {

constexpr Box kComposedBox{{0, 0}, {8, 8}};
constexpr Rgb kRed{1, 0, 0}, kBlue{0, 0, 1};

/// Returns layers of one colour each over the whole box, bottom first.
Picture stacked(const std::vector<PatchLayer>& layers) {
  Picture picture = make_picture(layers[0]);
  for (std::size_t i = 1; i < layers.size(); ++i) {
    picture.layers.push_back(layers[i]);
    picture.stack.push_back(PatchInstance{static_cast<std::uint32_t>(i), {}});
  }
  return picture;
}

void expect_color(const Image& image, const Rgb& expected, double steps = 1.5) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      ASSERT_NEAR(channel(image, x, y, 0), 65535 * expected.r, steps) << x << ' ' << y;
      ASSERT_NEAR(channel(image, x, y, 1), 65535 * expected.g, steps) << x << ' ' << y;
      ASSERT_NEAR(channel(image, x, y, 2), 65535 * expected.b, steps) << x << ' ' << y;
    }
  }
}

TEST(RasterCompositing, a_uniform_opacity_mixes_the_layer_with_the_background) {
  Picture picture = make_picture(flat_layer(kComposedBox, {0.8f, 0.2f, 0.6f}, 0.5f));
  picture.background = Rgb{0.4f, 1, 0};
  expect_color(rasterized(picture, image_size(40, 30)), {0.6f, 0.6f, 0.3f});
  picture.background.reset();
  expect_color(rasterized(picture, image_size(40, 30)), {0.9f, 0.6f, 0.8f});  // white
  picture.layers[0] = flat_layer(kComposedBox, {0.8f, 0.2f, 0.6f});
  std::get<PatchInstance>(picture.stack[0]).opacity = 0.5f;
  expect_color(rasterized(picture, image_size(40, 30)), {0.9f, 0.6f, 0.8f});
}

TEST(RasterCompositing, an_image_with_alpha_keeps_colour_and_opacity_apart) {
  const Picture picture = make_picture(flat_layer(kComposedBox, {0.8f, 0.2f, 0.6f}, 0.25f));
  const Image image = rasterized(picture, image_size(40, 30, PixelFormat::rgba16));
  expect_color(image, {0.8f, 0.2f, 0.6f}, 2);
  EXPECT_NEAR(channel(image, 20, 7, 3), 65535 * 0.25, 1);
}

TEST(RasterCompositing, an_opaque_opacity_is_no_opacity) {
  const Picture opaque = make_picture(flat_layer(kComposedBox, {0.8f, 0.2f, 0.6f}));
  const Picture covered = make_picture(flat_layer(kComposedBox, {0.8f, 0.2f, 0.6f}, 1));
  for (PixelFormat format : {PixelFormat::rgb8, PixelFormat::rgba8, PixelFormat::rgba16}) {
    const RasterOptions options = image_size(70, 90, format);
    EXPECT_EQ(rasterized(opaque, options).bytes, rasterized(covered, options).bytes);
  }
}

TEST(RasterCompositing, later_layers_lie_over_earlier_ones) {
  const PatchLayer red = flat_layer(kComposedBox, kRed, 0.5f),
                   blue = flat_layer(kComposedBox, kBlue, 0.5f);
  Picture picture = stacked({flat_layer(kComposedBox, {0, 0, 0}), red, blue});
  expect_color(rasterized(picture, image_size(9, 9)), {0.25f, 0, 0.5f});
  picture = stacked({flat_layer(kComposedBox, {0, 0, 0}), blue, red});
  expect_color(rasterized(picture, image_size(9, 9)), {0.5f, 0, 0.25f});
}

TEST(RasterCompositing, an_opaque_layer_hides_what_lies_below) {
  const Picture picture =
      stacked({flat_layer(kComposedBox, kRed, 0.5f), flat_layer(kComposedBox, kBlue)});
  const Image image = rasterized(picture, image_size(9, 9, PixelFormat::rgba16));
  expect_color(image, kBlue);
  EXPECT_EQ(channel(image, 4, 4, 3), 65535);
}

TEST(RasterCompositing, a_group_fades_as_one) {
  Picture picture = stacked({flat_layer(kComposedBox, {0, 0, 0}), flat_layer(kComposedBox, kRed),
                             flat_layer(kComposedBox, kBlue)});
  picture.stack = {PatchInstance{0, {}}, GroupBegin{0.5f, {}}, PatchInstance{1, {}},
                   PatchInstance{2, {}}, GroupEnd{}};
  expect_color(rasterized(picture, image_size(9, 9)), {0, 0, 0.5f});
  picture.stack = {PatchInstance{0, {}}, PatchInstance{1, {}, 0.5f}, PatchInstance{2, {}, 0.5f}};
  expect_color(rasterized(picture, image_size(9, 9)), {0.25f, 0, 0.5f});
}

TEST(RasterCompositing, a_group_is_blended_by_itself) {
  // Multiplied onto the white backdrop, red stays red; in the group, it is also multiplied onto
  // nothing.
  Picture picture =
      stacked({flat_layer(kComposedBox, {0.5f, 0.5f, 0.5f}), flat_layer(kComposedBox, kRed)});
  const PatchInstance multiplied{1, {}, 1, BlendMode::multiply};
  picture.stack = {PatchInstance{0, {}}, GroupBegin{}, multiplied, GroupEnd{}};
  expect_color(rasterized(picture, image_size(9, 9)), kRed);
  picture.stack = {PatchInstance{0, {}}, GroupBegin{1, BlendMode::multiply}, PatchInstance{1, {}},
                   GroupEnd{}};
  expect_color(rasterized(picture, image_size(9, 9)), {0.5f, 0, 0});
}

TEST(RasterCompositing, groups_nest_to_the_limit) {
  Picture picture =
      stacked({flat_layer(kComposedBox, {0, 0, 0}), flat_layer(kComposedBox, {1, 1, 1})});
  picture.stack.pop_back();
  for (std::size_t i = 0; i < limits::kGroupDepth; ++i)
    picture.stack.push_back(GroupBegin{i < 3 ? 0.5f : 1.0f, {}});
  picture.stack.push_back(PatchInstance{1, {0.5, 0, 0, 0.5, 0, 0}});
  for (std::size_t i = 0; i < limits::kGroupDepth; ++i) picture.stack.push_back(GroupEnd{});
  const Image image = rasterized(picture, image_size(600, 200));
  EXPECT_NEAR(channel(image, 100, 50, 1), 65535 / 8.0, 1);
  EXPECT_NEAR(channel(image, 299, 99, 1), 65535 / 8.0, 1);
  EXPECT_EQ(channel(image, 301, 50, 1), 0);
  EXPECT_EQ(channel(image, 100, 101, 1), 0);
}

TEST(RasterCompositing, what_stands_apart_in_a_group_leaves_nothing_between) {
  Picture picture =
      stacked({flat_layer(kComposedBox, {0, 0, 0}), flat_layer(kComposedBox, {1, 1, 1})});
  picture.stack.pop_back();
  picture.stack.push_back(GroupBegin{0.5f, {}});
  for (const auto& [x, y] : {std::pair{1.0, 1.0}, {6.5, 5.0}, {0.5, 6.0}, {3.0, 3.0}})
    picture.stack.push_back(PatchInstance{1, {0.125, 0, 0, 0.125, x, y}, 0.5f});
  picture.stack.push_back(GroupEnd{});
  const int side = 64;
  for (int repeat = 0; repeat < 2; ++repeat) {
    const Image image = rasterized(picture, image_size(side, side));
    double sum = 0;
    for (int i = 0; i < side * side; ++i) sum += channel(image, i % side, i / side, 0);
    EXPECT_NEAR(sum / 65535, 4 * 64 * 0.25, 0.1);
  }
}

TEST(RasterCompositing, a_soft_mask_has_no_fringe) {
  // Red inside, where it is opaque; blue outside, where it is not.
  for (const auto& [a, b] : {std::pair{Vec2{3.3, 8}, Vec2{4.9, 0}}, {{0, 2.2}, {8, 5.1}}}) {
    const RegionMesh mesh = cut_box(kComposedBox, a, b);
    PatchLayer layer = make_layer(mesh, [](int region, Vec2) { return region ? kBlue : kRed; });
    set_opacity(
        mesh, [](int region, Vec2) { return region ? 0.0f : 1.0f; }, &layer);
    const Image image = rasterized(make_picture(layer), image_size(61, 47, PixelFormat::rgba16));
    int partial = 0;
    for (int i = 0; i < 61 * 47; ++i) {
      const int x = i % 61, y = i / 61;
      const int alpha = channel(image, x, y, 3);
      partial += alpha > 0 && alpha < 65535;
      ASSERT_GE(channel(image, x, y, 0), alpha > 0 ? 65535 - 2 : 0);
      ASSERT_EQ(channel(image, x, y, 2), 0);
    }
    EXPECT_GT(partial, 40);
  }
}

TEST(RasterCompositing, dropped_triangles_are_as_transparent_as_those_of_opacity_0) {
  RegionMesh mesh = cut_box(kComposedBox, {3.3, 8}, {4.9, 0});
  const auto color = [](int, Vec2 p) { return Rgb{static_cast<float>(p.x / 8), 0.5f, 0}; };
  const auto opacity = [](int region, Vec2) { return region ? 0.0f : 0.75f; };
  PatchLayer whole = make_layer(mesh, color);
  set_opacity(mesh, opacity, &whole);
  PatchLayer part = whole;  // only region 0, the first two triangles
  part.triangle_vertex.resize(6);
  part.edge_is_curve.resize(6);
  part.color.triangle_node.resize(20);
  part.opacity.triangle_node.resize(20);
  const RasterOptions options = image_size(61, 47, PixelFormat::rgba16);
  const Image a = rasterized(make_picture(whole), options);
  const Image b = rasterized(make_picture(part), options);
  for (int i = 0; i < 61 * 47 * 4; ++i) {
    const int x = i / 4 % 61, y = i / 4 / 61;
    ASSERT_NEAR(channel(a, x, y, i % 4), channel(b, x, y, i % 4), 3) << x << ' ' << y;
  }
}

TEST(RasterCompositing, a_smooth_opacity_is_the_patch_at_the_centre) {
  const RegionMesh mesh = jittered_grid(kComposedBox, 5, 3);
  PatchLayer layer = make_layer(mesh, [](int, Vec2) { return Rgb{1, 1, 1}; });
  const auto opacity = [](int, Vec2 p) {
    return static_cast<float>(0.1 + 0.1 * p.x - 0.002 * p.x * p.y * p.y + 0.03 * p.y);
  };
  set_opacity(mesh, opacity, &layer);
  const Image image = rasterized(make_picture(layer), image_size(300, 150, PixelFormat::rgba16));
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 300; ++x) {
      const double expected = opacity(0, {(x + 0.5) * 8 / 300, (y + 0.5) * 8 / 150});
      ASSERT_NEAR(channel(image, x, y, 3), 65535 * expected, 2);
    }
  }
}

TEST(RasterCompositing, opacity_beyond_its_range_is_clamped) {
  Picture picture = make_picture(flat_layer(kComposedBox, kRed, 1.75f));
  picture.background = kBlue;
  expect_color(rasterized(picture, image_size(9, 9)), kRed);
  picture.layers[0] = flat_layer(kComposedBox, kRed, -0.5f);
  expect_color(rasterized(picture, image_size(9, 9)), kBlue);
}

Rgb smooth_wave(int region, Vec2 p) {
  const auto wave = [&](double a, double b) {
    return static_cast<float>(0.5 + 0.5 * std::sin(a * p.x + b * p.y + region));
  };
  return {wave(1.1, 0.2), wave(-0.7, 1.3), wave(0.5, -1)};
}

TEST(RasterCompositing, an_instance_equals_the_transformed_layer_alone) {
  const RegionMesh mesh =
      jittered_grid({{-3, -3}, {3, 3}}, 6, 4, [](int i, int j) { return i * j % 3; });
  const auto soft = [](int region, Vec2 p) {
    return static_cast<float>(0.5 + 0.4 * std::cos(p.x - p.y + region));
  };
  PatchLayer layer = make_layer(mesh, smooth_wave);
  set_opacity(mesh, soft, &layer);
  const Affine maps[] = {{1, 0, 0, 1, 4.013, 3.991},
                         {-0.71, 0, 0, 0.93, 3.1, 4.017},
                         {0.51, 0.4, -0.4, 0.52, 4.03, 3},
                         {0.6, 0.1, 0.5, 0.7, 5, 4},
                         {0.11, -0.8, -0.6, -0.21, 4.07, 3.96},
                         {0.03, 0, 0, 0.02, 2.2, 7}};
  for (const Affine& map : maps) {
    RegionMesh moved = mesh;
    for (Vec2& p : moved.vertex) p = map(p);
    if (map.determinant() < 0)
      for (Corners& corner : moved.triangle) std::swap(corner[1], corner[2]);
    const Affine back = inverse(map);
    PatchLayer alone =
        make_layer(moved, [&](int region, Vec2 p) { return smooth_wave(region, back(p)); });
    set_opacity(
        moved, [&](int region, Vec2 p) { return soft(region, back(p)); }, &alone);
    Picture instance = make_picture(layer), expected = make_picture(alone);
    instance.viewport = expected.viewport = kComposedBox;
    // The frame of a rotated layer is not a rectangle: without a frame, pixels at the rim are all
    // or none.
    instance.layers[0].frame = expected.layers[0].frame = Box{};
    std::get<PatchInstance>(instance.stack[0]).artboard_from_layer = map;
    const Image a = rasterized(instance, image_size(300, 200, PixelFormat::rgba16));
    const Image b = rasterized(expected, image_size(300, 200, PixelFormat::rgba16));
    int on_the_rim = 0;  // centres that rounding puts on either side
    for (int i = 0; i < 300 * 200; ++i) {
      const int x = i % 300, y = i / 300;
      const int alpha = channel(a, x, y, 3);
      const bool both = alpha > 0 && channel(b, x, y, 3) > 0;
      on_the_rim += !both && alpha != channel(b, x, y, 3);
      for (int c = 0; c < 4 && both; ++c) {
        // A hundredth of a code value, except for colours of nearly transparent pixels.
        const double steps = c < 3 && alpha < 2000 ? 2000 : 20;
        ASSERT_NEAR(channel(a, x, y, c), channel(b, x, y, c), steps) << x << ' ' << y;
      }
    }
    EXPECT_LE(on_the_rim, 2);
  }
}

TEST(RasterCompositing, an_instance_whose_corner_is_magnified_beyond_measure_is_still_there) {
  for (double scale : {1e3, 1e9, 1e15, 1e22}) {
    Picture picture = make_picture(flat_layer(kComposedBox, kRed, 0.5f));
    picture.viewport = {{0, 0}, {8 / scale, 8 / scale}};
    picture.background = kBlue;
    expect_color(rasterized(picture, image_size(9, 9)), {0.5f, 0, 0.5f});
    picture.viewport = {{8 - 8 / scale, 0}, {8, 8 / scale}};
    if (scale < 1e10) expect_color(rasterized(picture, image_size(9, 9)), {0.5f, 0, 0.5f});
  }
}

TEST(RasterCompositing, a_map_onto_a_line_is_refused_as_in_documents) {
  Picture picture = make_picture(flat_layer(kComposedBox, kRed, 0.5f));
  std::get<PatchInstance>(picture.stack[0]).artboard_from_layer = {1, 1, 1, 1, 0, 0};
  Context context;
  EXPECT_EQ(rasterize(context, picture, image_size(9, 9)).status().code, StatusCode::bad_input);
}

TEST(RasterCompositing, colours_are_interpolated_in_the_space_of_the_picture) {
  const RegionMesh mesh = jittered_grid(kComposedBox, 4, 3);
  const Rgb from{0.9f, 0.1f, 0.2f}, to{0.1f, 0.8f, 0.9f};
  for (InterpolationSpace space :
       {InterpolationSpace::srgb, InterpolationSpace::linear, InterpolationSpace::oklab}) {
    const auto field = [&](Vec2 p) {
      return lerp(from_srgb(space, from), from_srgb(space, to), static_cast<float>(p.x / 8));
    };
    Picture picture = make_picture(make_layer(mesh, [&](int, Vec2 p) { return field(p); }));
    picture.interpolation = space;
    const Image image = rasterized(picture, image_size(100, 10));
    for (int x = 0; x < 100; ++x) {
      const Rgb expected = to_srgb(space, field({(x + 0.5) * 8 / 100, 4}));
      EXPECT_NEAR(channel(image, x, 5, 0), 65535 * expected.r, 3);
      EXPECT_NEAR(channel(image, x, 5, 1), 65535 * expected.g, 3);
      EXPECT_NEAR(channel(image, x, 5, 2), 65535 * expected.b, 3);
    }
  }
}

TEST(RasterCompositing, mixed_pixels_average_code_values_in_every_space) {
  const RegionMesh mesh = cut_box(kComposedBox, {4, 8}, {4, 0});
  for (InterpolationSpace space : {InterpolationSpace::linear, InterpolationSpace::oklab}) {
    Picture picture = make_picture(make_layer(mesh, [&](int region, Vec2) {
      return from_srgb(space, region ? Rgb{0.2f, 0.4f, 1} : Rgb{0.8f, 0, 0.2f});
    }));
    picture.interpolation = space;
    const Image image = rasterized(picture, image_size(5, 5));
    EXPECT_NEAR(channel(image, 2, 2, 0), 65535 * 0.5, 2);
    EXPECT_NEAR(channel(image, 2, 2, 1), 65535 * 0.2, 2);
    EXPECT_NEAR(channel(image, 2, 2, 2), 65535 * 0.6, 2);
  }
}

TEST(RasterCompositing, the_overlay_shows_every_instance) {
  Picture picture = make_picture(flat_layer(kComposedBox, {1, 1, 1}, 0.5f));
  picture.viewport = kComposedBox;
  picture.stack = {PatchInstance{0, {0.25, 0, 0, 0.25, 1, 1}},
                   PatchInstance{0, {0.25, 0, 0, 0.25, 5, 5}}};
  RasterOptions options = image_size(64, 64, PixelFormat::rgb8);
  options.mesh_overlay = true;
  const Image image = rasterized(picture, options);
  const auto inked = [&](int x0, int y0) {
    int count = 0;
    for (int i = 0; i < 20 * 20; ++i) count += channel(image, x0 + i % 20, y0 + i / 20, 0) < 250;
    return count;
  };
  EXPECT_GT(inked(6, 6), 40);
  EXPECT_GT(inked(38, 38), 40);
  EXPECT_EQ(inked(38, 6), 0);
}

}  // namespace
}  // namespace sfumato::test
