#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

#include "raster/coverage/tile_bins.hpp"
#include "raster/layers/layer_view.hpp"
#include "raster/pictures.hpp"
#include "raster/support.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::test {
namespace {

Picture plain_picture() {
  return make_picture(make_layer(jittered_grid({{0, 0}, {8, 8}}, 4, 1), [](int, Vec2) {
    return Rgb{0.25f, 0.5f, 0.75f};
  }));
}

StatusCode code_of(const Picture& picture, const RasterOptions& options) {
  Context context;
  return rasterize(context, picture, options).status().code;
}

/// Cancels at the first report, and records the largest charge.
struct Watcher : Progress {
  Context* context = nullptr;
  bool cancels = false;
  std::atomic<std::size_t> peak{0};
  std::atomic<int> reports{0};

  void report(std::string_view, double fraction) override {
    EXPECT_GT(fraction, 0);
    EXPECT_LE(fraction, 1);
    ++reports;
    const std::size_t used = context->budget.used();
    if (used > peak) peak = used;
    if (cancels) context->cancel = true;
  }
};

TEST(RasterLimits, an_image_without_pixels_is_bad_input) {
  const Picture picture = plain_picture();
  for (const auto& [width, height] : {std::pair{0, 4}, {4, 0}, {-1, 4}, {4, -2147483647}})
    EXPECT_EQ(code_of(picture, image_size(width, height)), StatusCode::bad_input);
}

TEST(RasterLimits, an_image_beyond_the_limit_is_refused) {
  const Picture picture = plain_picture();
  EXPECT_EQ(code_of(picture, image_size(limits::kImageSide + 1, 1)), StatusCode::limit);
  EXPECT_EQ(code_of(picture, image_size(1, 2147483647)), StatusCode::limit);
}

TEST(RasterLimits, an_empty_or_endless_viewport_is_bad_input) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Box& viewport :
       {Box{}, Box{{0, 0}, {0, 8}}, Box{{5, 0}, {4, 8}}, Box{{0, 0}, {infinity, 8}},
        Box{{0, 0}, {1, std::nan("")}}, Box{{0, 0}, {1e-200, 1}}}) {
    RasterOptions options = image_size(4, 4);
    options.viewport = viewport;
    EXPECT_EQ(code_of(plain_picture(), options), StatusCode::bad_input);
  }
}

TEST(RasterLimits, a_picture_whose_tables_do_not_fit_is_bad_input) {
  const auto refused = [](const std::function<void(Picture&)>& spoil) {
    Picture picture = plain_picture();
    spoil(picture);
    EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  };
  refused([](Picture& p) { std::get<PatchInstance>(p.stack[0]).layer = 1; });
  refused([](Picture& p) { p.layers[0].triangle_vertex[3] = 1000; });
  refused([](Picture& p) { p.layers[0].color.triangle_node[3] = 100000; });
  refused([](Picture& p) { p.layers[0].edge_is_curve.pop_back(); });
  refused([](Picture& p) { p.layers[0].color.triangle_node.pop_back(); });
  refused([](Picture& p) { p.layers[0].color.node_value.clear(); });
  refused([](Picture& p) { p.layers[0].color.channel_count = 0; });
  refused([](Picture& p) { p.layers[0].vertex_position[3].x = std::nan(""); });
  refused([](Picture& p) { std::get<PatchInstance>(p.stack[0]).artboard_from_layer.e = 1e300; });
  refused([](Picture& p) { p.layers[0].color.channel_count = 4; });
  refused([](Picture& p) { p.layers[0].color.channel_count = -3; });
  refused([](Picture& p) { p.layers[0].order = static_cast<PatchOrder>(3); });
  refused([](Picture& p) { p.interpolation = static_cast<InterpolationSpace>(7); });
}

TEST(RasterLimits, an_opacity_whose_tables_do_not_fit_is_bad_input) {
  const auto refused = [](const std::function<void(PatchField&)>& spoil) {
    Picture picture = make_picture(flat_layer({{0, 0}, {8, 8}}, {}, 0.5f));
    spoil(picture.layers[0].opacity);
    EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  };
  refused([](PatchField& f) { f.channel_count = 2; });
  refused([](PatchField& f) { f.channel_count = -1; });
  refused([](PatchField& f) { f.triangle_node.pop_back(); });
  refused([](PatchField& f) { f.triangle_node[7] = 100000; });
  refused([](PatchField& f) { f.node_value.pop_back(); });
  refused([](PatchField& f) { f.shader.push_back(0); });
}

TEST(RasterLimits, weights_of_shaders_that_are_not_there_are_bad_input) {
  const RegionMesh mesh = jittered_grid({{0, 0}, {8, 8}}, 4, 1);
  Picture picture = plain_picture();
  const auto weight = [](int, Vec2) { return 0.5f; };
  add_weight(mesh, 0, weight, &picture.layers[0].color);
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  picture = make_picture(flat_layer({{0, 0}, {8, 8}}, {}, 0.5f));
  add_weight(jittered_grid({{0, 0}, {8, 8}}, 2, 1), 3, weight, &picture.layers[0].opacity);
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
}

TEST(RasterLimits, a_shader_that_is_none_is_bad_input) {
  Picture picture = plain_picture();
  picture.shaders.push_back({"empty", Texture{}});
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  picture.shaders[0].paint = Texture{4, 4, std::vector<std::uint8_t>(63), {}, true, {}, {}};
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  picture.shaders[0].paint = GradientFill{};
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
}

TEST(RasterLimits, too_many_shaders_in_a_layer_are_refused) {
  Picture picture = plain_picture();
  PatchField& field = picture.layers[0].color;
  field.shader.assign(limits::kShadersPerLayer + 1, 0);
  field.channel_count = 3 + static_cast<int>(field.shader.size());
  EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::limit);
}

TEST(RasterLimits, groups_must_be_closed_and_not_too_deep) {
  Picture picture = plain_picture();
  const auto code_with = [&](std::vector<PictureItem> stack) {
    picture.stack = std::move(stack);
    return code_of(picture, image_size(4, 4));
  };
  EXPECT_EQ(code_with({GroupBegin{}}), StatusCode::bad_input);
  EXPECT_EQ(code_with({GroupEnd{}}), StatusCode::bad_input);
  EXPECT_EQ(code_with({GroupBegin{}, GroupEnd{}, GroupEnd{}, GroupBegin{}}), StatusCode::bad_input);
  EXPECT_EQ(code_with({GroupBegin{}, GroupEnd{}}), StatusCode::ok);
  EXPECT_EQ(code_with(std::vector<PictureItem>(limits::kGroupDepth + 1, GroupBegin{})),
            StatusCode::limit);
  EXPECT_EQ(code_with(std::vector<PictureItem>(limits::kStackItems + 1, PatchInstance{})),
            StatusCode::limit);
}

TEST(RasterLimits, opacities_and_modes_that_do_not_exist_are_bad_input) {
  Picture picture = plain_picture();
  for (const auto& [opacity, mode] :
       {std::pair{-0.1f, 0}, {1.1f, 0}, {std::nanf(""), 0}, {1.0f, 16}}) {
    const BlendMode blend = static_cast<BlendMode>(mode);
    picture.stack = {PatchInstance{0, {}, opacity, blend}};
    EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
    picture.stack = {GroupBegin{opacity, blend}, GroupEnd{}};
    EXPECT_EQ(code_of(picture, image_size(4, 4)), StatusCode::bad_input);
  }
}

TEST(RasterLimits, a_stack_of_the_largest_size_needs_little_memory) {
  Picture picture = plain_picture();
  picture.viewport = {{0, 0}, {1000, 1000}};
  picture.stack.clear();
  for (std::size_t i = 0; i < limits::kStackItems; ++i) {
    const double x = static_cast<double>(i % 450), y = static_cast<double>(i / 450);
    picture.stack.push_back(PatchInstance{0, {0.1, 0, 0, 0.1, 2.2 * x, 2.2 * y}, 0.5f});
  }
  Context context;
  Watcher watcher;
  watcher.context = &context;
  context.progress = &watcher;
  ASSERT_TRUE(rasterize(context, picture, image_size(64, 64)).ok());
  EXPECT_LT(watcher.peak.load(), std::size_t{100} << 20);
}

TEST(RasterLimits, the_image_is_charged_before_it_is_made) {
  Context context;
  const std::size_t others = context.budget.limit() - (1 << 20);
  ASSERT_TRUE(context.budget.charge(others, "other work").ok());
  const Result<Image> image = rasterize(context, plain_picture(), image_size(1024, 1024));
  EXPECT_EQ(image.status().code, StatusCode::limit);
  EXPECT_EQ(context.budget.used(), others);
}

TEST(RasterLimits, cancellation_is_seen) {
  Context context;
  context.cancel = true;
  const Result<Image> image = rasterize(context, plain_picture(), image_size(64, 64));
  EXPECT_EQ(image.status().code, StatusCode::cancelled);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(RasterLimits, cancellation_stops_between_tiles) {
  Context context;
  Watcher watcher;
  watcher.context = &context;
  watcher.cancels = true;
  context.progress = &watcher;
  const Result<Image> image = rasterize(context, plain_picture(), image_size(2048, 2048));
  EXPECT_EQ(image.status().code, StatusCode::cancelled);
  EXPECT_EQ(watcher.reports, 1);
}

TEST(RasterLimits, the_widest_image_needs_little_more_than_its_bytes) {
  ThreadPool executor(8);
  Context context;
  context.executor = &executor;
  Watcher watcher;
  watcher.context = &context;
  context.progress = &watcher;
  const Result<Image> image =
      rasterize(context, plain_picture(), image_size(limits::kImageSide, 128, PixelFormat::rgb8));
  ASSERT_TRUE(image.ok());
  const std::size_t image_bytes = image->bytes.size();
  EXPECT_EQ(image_bytes, std::size_t{3} * limits::kImageSide * 128);
  EXPECT_GE(watcher.peak.load(), image_bytes);
  EXPECT_LT(watcher.peak.load(), image_bytes + (std::size_t{32} << 20));
  EXPECT_EQ(channel(*image, limits::kImageSide - 1, 127, 2), 191);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(RasterLimits, far_coordinates_and_extreme_scales_end_in_an_image) {
  RegionMesh mesh;
  mesh.vertex = {{-1e7, -1e7}, {1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}};
  mesh.add(0, 1, 2, 0);
  mesh.add(0, 2, 3, 1);
  Picture picture = make_picture(make_layer(mesh, [](int region, Vec2) {
    return Rgb{0.2f, 0.4f, region ? 0.6f : 0.6f};
  }));
  for (double side : {1e-90, 1e-12, 1e-9, 1e-3, 1.0, 1e7, 1e12, 1e300}) {
    picture.viewport = {{0.1 * side, 0.1 * side}, {1.1 * side, 1.1 * side}};
    const Image image = rasterized(picture, image_size(33, 33, PixelFormat::rgb8));
    if (side > 1e6) continue;
    for (int i = 0; i < 33 * 33; ++i) ASSERT_EQ(channel(image, i % 33, i / 33, 0), 51);
  }
}

TEST(RasterLimits, values_that_are_not_numbers_end_in_an_image) {
  Picture picture = make_picture(flat_layer({{0, 0}, {8, 8}}, {0.25f, 0.5f, 0.75f}, 0.5f));
  for (PatchField* field : {&picture.layers[0].color, &picture.layers[0].opacity}) {
    for (std::size_t i = 0; i < field->node_value.size(); i += 7)
      field->node_value[i] = i % 2 ? std::nan("") : INFINITY;
  }
  PatchLayer opaque = picture.layers[0];
  opaque.opacity = {};
  picture.layers.push_back(opaque);
  picture.stack.insert(picture.stack.begin(), PatchInstance{1, {}});
  for (int mode = 0; mode < 16; ++mode)
    picture.stack.push_back(PatchInstance{0, {}, 0.9f, static_cast<BlendMode>(mode)});
  for (std::uint8_t& is_curve : picture.layers[0].edge_is_curve) is_curve = 1;
  EXPECT_EQ(rasterized(picture, image_size(40, 40, PixelFormat::rgba8)).bytes.size(), 6400u);
}

TEST(RasterLimits, needles_across_a_huge_image_are_listed_along_their_length) {
  RegionMesh mesh;
  mesh.vertex = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  constexpr std::uint32_t kNeedles = 300;
  for (std::uint32_t i = 0; i <= kNeedles; ++i)
    mesh.vertex.push_back({0.9 + 0.1 * i / kNeedles, 1.0 - 0.1 * i / kNeedles});
  for (std::uint32_t i = 0; i < kNeedles; ++i) mesh.add(0, 5 + i, 4 + i, 0);
  const Picture picture = make_picture(make_layer(mesh, [](int, Vec2) { return Rgb{}; }));
  const double side = limits::kImageSide;
  const raster::LayerView view = raster::view_instance(
      picture, std::get<PatchInstance>(picture.stack[0]), {side, 0, 0, side, 0, 0});
  const raster::TileGrid grid{limits::kImageSide, limits::kImageSide};
  Context context;
  const auto bins = raster::bin_triangles(context, view, kNeedles, grid, 0);
  ASSERT_TRUE(bins.ok());
  // At most 3 tiles wide in each of 256 rows, or 7 high in each of 64 columns.
  EXPECT_LT(bins->triangle.size(), kNeedles * 3 * 256);
  EXPECT_GT(bins->triangle.size(), kNeedles * 256);
}

}  // namespace
}  // namespace sfumato::test
