// Compares the GPU's picture with the CPU's (docs/gpu.md, "How near to the CPU").
#include "sfumato/gpu/render.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "raster/pictures.hpp"
#include "support.hpp"

namespace sfumato::test {
namespace {

const Box kBox{{0, 0}, {64, 48}};

Rgb wavy(int region, Vec2 p) {
  const auto wave = [&](double kx, double ky) {
    return static_cast<float>(0.5 + 0.45 * std::sin(kx * p.x + ky * p.y + 2.1 * region));
  };
  return {wave(0.11, 0.02), wave(-0.07, 0.13), wave(0.05, -0.16)};
}

RegionMesh checkered(int cells) {
  return jittered_grid(kBox, cells, 7, [](int column, int row) { return (column / 2 + row) % 3; });
}

Picture wavy_picture() {
  return make_picture(make_layer(checkered(8), wavy));
}

/// Returns the same layer with an opacity.
PatchLayer veil() {
  const RegionMesh mesh = checkered(6);
  PatchLayer layer = make_layer(mesh, wavy);
  set_opacity(
      mesh, [](int region, Vec2 p) { return static_cast<float>(p.x / 64) * (1 - 0.4f * region); },
      &layer);
  return layer;
}

/// Returns `wavy` with the veil on top, rotated, in a blend mode.
Picture veiled(float opacity, BlendMode mode) {
  Picture picture = wavy_picture();
  picture.layers.push_back(veil());
  picture.stack.push_back(PatchInstance{1, {0.6, 0.31, -0.32, 0.6, 20.3, 4.1}, opacity, mode});
  return picture;
}

TEST(GpuRender, patches_of_every_order_agree) {
  SFUMATO_NEEDS_GPU();
  for (PatchOrder order : {PatchOrder::linear, PatchOrder::quadratic, PatchOrder::cubic}) {
    Picture picture = wavy_picture();
    picture.layers[0].order = order;
    expect_near(picture, image_size(320, 240, PixelFormat::rgb8));
  }
}

TEST(GpuRender, every_interpolation_space_agrees) {
  SFUMATO_NEEDS_GPU();
  for (InterpolationSpace space :
       {InterpolationSpace::srgb, InterpolationSpace::linear, InterpolationSpace::oklab}) {
    Picture picture = veiled(0.8f, BlendMode::normal);
    picture.interpolation = space;
    expect_near(picture, image_size(200, 150, PixelFormat::rgb8));
  }
}

TEST(GpuRender, every_blend_mode_agrees) {
  SFUMATO_NEEDS_GPU();
  for (int mode = 0; mode <= static_cast<int>(BlendMode::luminosity); ++mode) {
    SCOPED_TRACE(mode);
    expect_near(veiled(0.7f, static_cast<BlendMode>(mode)),
                image_size(128, 96, PixelFormat::rgba8));
  }
}

TEST(GpuRender, groups_within_groups_agree) {
  SFUMATO_NEEDS_GPU();
  Picture picture = wavy_picture();
  picture.layers.push_back(veil());
  picture.stack.push_back(GroupBegin{0.7f, BlendMode::multiply});
  picture.stack.push_back(PatchInstance{1, {1, 0, 0, 1, -10, 5}, 0.9f, BlendMode::normal});
  picture.stack.push_back(GroupBegin{0.5f, BlendMode::screen});
  picture.stack.push_back(PatchInstance{1, {0.5, 0, 0.2, -0.5, 20, 40}, 1, BlendMode::difference});
  picture.stack.push_back(GroupEnd{});
  picture.stack.push_back(GroupEnd{});
  picture.stack.push_back(GroupBegin{});
  picture.stack.push_back(GroupEnd{});
  expect_near(picture, image_size(160, 120, PixelFormat::rgba8));
  expect_near(picture, image_size(160, 120, PixelFormat::rgb8));
}

TEST(GpuRender, every_format_and_the_dither_agree) {
  SFUMATO_NEEDS_GPU();
  const Picture picture = veiled(0.6f, BlendMode::normal);
  for (PixelFormat format :
       {PixelFormat::rgb8, PixelFormat::rgba8, PixelFormat::rgb16, PixelFormat::rgba16}) {
    expect_near(picture, image_size(100, 75, format));
    RasterOptions tinted = image_size(100, 75, format);
    tinted.background = Rgb{0.2f, 0.6f, 0.9f};
    tinted.dither = bytes_per_channel(format) == 1;
    expect_near(picture, tinted);
  }
}

TEST(GpuRender, sixteen_bits_agree_to_ten_steps) {
  SFUMATO_NEEDS_GPU();
  const auto device = gpu::Device::create();
  if (!(*device)->blends_floats()) GTEST_SKIP() << "this device blends 16-bit floats only";
  const Picture picture = wavy_picture();
  const RasterOptions options = image_size(100, 75, PixelFormat::rgb16);
  const Nearness near = nearness(rasterized(picture, options), on_gpu(picture, options));
  EXPECT_LT(near.worst * 257, 10);
}

TEST(GpuRender, without_antialiasing_centres_decide) {
  SFUMATO_NEEDS_GPU();
  RasterOptions options = image_size(300, 225, PixelFormat::rgb8);
  options.antialias = false;
  expect_near(veiled(1, BlendMode::normal), options);
}

TEST(GpuRender, the_overlay_agrees) {
  SFUMATO_NEEDS_GPU();
  RasterOptions options = image_size(300, 225, PixelFormat::rgba8);
  options.mesh_overlay = true;
  expect_near(veiled(1, BlendMode::normal), options);
}

TEST(GpuRender, windows_are_refused) {
  RasterOptions options = image_size(10, 10);
  options.window = RasterWindow{0, 0, 100, 100};
  Context context;
  EXPECT_EQ(render_on_gpu(context, Picture{}, options).status().code, StatusCode::bad_input);
}

TEST(GpuRender, images_of_several_tiles_agree) {
  SFUMATO_NEEDS_GPU();
  expect_near(veiled(0.8f, BlendMode::overlay), image_size(1300, 1040, PixelFormat::rgb8));
}

TEST(GpuRender, a_deep_zoom_agrees) {
  SFUMATO_NEEDS_GPU();
  RasterOptions options = image_size(160, 120, PixelFormat::rgb8);
  options.viewport = Box{{41.3, 29.1}, {41.3 + 64 / 500.0, 29.1 + 48 / 500.0}};
  expect_near(wavy_picture(), options);
}

TEST(GpuRender, an_empty_picture_is_its_background) {
  SFUMATO_NEEDS_GPU();
  Picture picture;
  picture.artboard = picture.viewport = kBox;
  expect_near(picture, image_size(8, 6, PixelFormat::rgba8));
  picture.background = Rgb{0.25f, 0.5f, 1};
  picture.layers.emplace_back();
  picture.stack.push_back(PatchInstance{});
  expect_near(picture, image_size(8, 6, PixelFormat::rgb8));
}

TEST(GpuRender, one_triangle_agrees) {
  SFUMATO_NEEDS_GPU();
  RegionMesh mesh;
  mesh.vertex = {{3, 4}, {60, 20}, {11, 44}};
  mesh.add(0, 1, 2, 0);
  Picture picture = make_picture(make_layer(mesh, wavy));
  picture.artboard = picture.viewport = kBox;
  expect_near(picture, image_size(64, 48, PixelFormat::rgba8));
}

TEST(GpuRender, outlines_through_pixel_centres_fall_to_the_same_side) {
  SFUMATO_NEEDS_GPU();
  Picture picture = make_picture(flat_layer(kBox, {0.9f, 0.2f, 0.1f}, 0.5f));
  picture.stack.clear();
  picture.stack.push_back(PatchInstance{0, {0.25, 0, 0, 0.25, 20.5, 10.5}, 1, BlendMode::normal});
  picture.stack.push_back(PatchInstance{0, {-0.25, 0, 0, 0.25, 60.5, 30.5}, 1, BlendMode::normal});
  expect_near(picture, image_size(64, 48, PixelFormat::rgba8));
}

TEST(GpuRender, triangles_without_an_area_leave_no_trace) {
  SFUMATO_NEEDS_GPU();
  RegionMesh mesh = checkered(4);
  mesh.add(0, 0, 1, 5);
  mesh.add(2, 7, 2, 5);
  expect_near(make_picture(make_layer(mesh, wavy)), image_size(64, 48, PixelFormat::rgb8));
}

TEST(GpuRender, values_out_of_range_are_clamped) {
  SFUMATO_NEEDS_GPU();
  const auto steep = [](int, Vec2 p) {
    return Rgb{static_cast<float>(p.x / 16 - 1), static_cast<float>(2 - p.y / 12), 7};
  };
  expect_near(make_picture(make_layer(checkered(6), steep)), image_size(64, 48, PixelFormat::rgb8));
}

TEST(GpuRender, what_is_not_a_number_stays_in_its_triangles) {
  SFUMATO_NEEDS_GPU();
  Picture picture = veiled(0.7f, BlendMode::multiply);
  const Image expected = rasterized(picture, image_size(64, 48, PixelFormat::rgb8));
  // The first quad is the upper left corner.
  for (std::size_t i = 0; i < 3 * 10; ++i)
    picture.layers[0].color.node_value[i] = std::numeric_limits<float>::quiet_NaN();
  const Image image = on_gpu(picture, image_size(64, 48, PixelFormat::rgb8));
  EXPECT_NEAR(channel(image, 40, 30, 0), channel(expected, 40, 30, 0), 1);
}

TEST(GpuRender, maps_that_explode_are_refused_as_the_cpu_refuses_them) {
  SFUMATO_NEEDS_GPU();
  Picture picture = veiled(1, BlendMode::normal);
  picture.stack.push_back(PatchInstance{1, {1e80, 0, 0, 1e80, 0, 0}, 1, BlendMode::normal});
  Context context;
  const Result<Image> image =
      render_on_gpu(context, picture, image_size(32, 24, PixelFormat::rgb8));
  EXPECT_EQ(image.status().code, StatusCode::bad_input);
}

}  // namespace
}  // namespace sfumato::test
