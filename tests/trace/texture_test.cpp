// The parts that the curves miss, as a texture on top.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sfumato/base/native/thread_pool.hpp"
#include "support/cancel_at.hpp"
#include "support/flat_art.hpp"
#include "support/poll_recorder.hpp"
#include "support/synthetic_photo.hpp"
#include "trace/tracing.hpp"

namespace sfumato {
namespace {

TraceOptions textured(int points) {
  return {.points = points, .edges_only = true, .has_texture = true};
}

/// Returns an image of one pixel.
Image pixel(PixelFormat format, std::vector<std::uint8_t> bytes) {
  return {1, 1, format, std::move(bytes)};
}

TEST(TraceTexture, lets_a_drawing_of_few_curves_look_like_its_photo) {
  const Image photo = test::synthetic_photo(160);
  TraceStats stats;
  const Document drawing = test::trace_of(photo, textured(60), &stats);
  EXPECT_LT(stats.rounds.back().psnr_db, 35);
  const double rendered = test::rendered_psnr_db(drawing, photo);
  EXPECT_GE(rendered, 50);
  ASSERT_TRUE(stats.textured_psnr_db.has_value());
  EXPECT_NEAR(*stats.textured_psnr_db, rendered, 0.5);
}

TEST(TraceTexture, is_one_layer_more_and_leaves_the_curves_as_they_are) {
  const Image photo = test::synthetic_photo(100);
  TraceOptions options = textured(80);
  const Document with = test::trace_of(photo, options);
  options.has_texture = false;
  TraceStats stats;
  const Document without = test::trace_of(photo, options, &stats);
  EXPECT_FALSE(stats.textured_psnr_db.has_value());
  EXPECT_TRUE(without.shaders.empty());
  ASSERT_EQ(with.layers.size(), 2u);
  EXPECT_EQ(with.layers[0].curves, without.layers[0].curves);
  EXPECT_EQ(with.layers[1].curves.size(), 1u);
  EXPECT_EQ(with.shaders.size(), 1u);
  ASSERT_EQ(with.stack.size(), 2u);
  EXPECT_EQ(std::get<LayerInstance>(with.stack[1]).blend, BlendMode::hard_light);
}

TEST(TraceTexture, survives_a_file) {
  const Image photo = test::synthetic_photo(100);
  const std::string text = test::svg_of(test::trace_of(photo, textured(80)));
  Context context;
  const Result<ReadDocument> read = read_document(context, text, "drawing.svg");
  ASSERT_TRUE(read.ok()) << to_string(read.status());
  EXPECT_TRUE(read->warnings.empty());
  EXPECT_GE(test::rendered_psnr_db(read->document, photo), 50);
}

TEST(TraceTexture, has_a_texel_to_a_pixel_looked_at) {
  const Image photo = test::synthetic_photo(200);
  TraceOptions options = textured(80);
  options.max_side = 60;
  TraceStats stats;
  const Document drawing = test::trace_of(photo, options, &stats);
  const auto& texture = std::get<Texture>(drawing.shaders.at(0).paint);
  EXPECT_LE(texture.width, 64);  // two on each side repeat the border
  EXPECT_GE(*stats.textured_psnr_db, 50);
  EXPECT_LT(test::rendered_psnr_db(drawing, photo), *stats.textured_psnr_db);
}

TEST(TraceTexture, shows_nothing_of_the_opposite_border_where_it_is_magnified) {
  Image halves{8, 4, PixelFormat::rgb8, {}};
  for (int i = 0; i < 32; ++i) {
    halves.bytes.insert(halves.bytes.end(), 3, static_cast<std::uint8_t>(i % 8 < 4 ? 20 : 230));
  }
  const Document drawing = test::trace_of(halves, {.max_curves = 1, .has_texture = true});
  const test::Planes look = test::look_of(drawing, 64, 32);
  for (const test::Plane& plane : look) {
    EXPECT_NEAR(plane.at(0, 16), 20 / 255.0, 0.02);
    EXPECT_NEAR(plane.at(63, 16), 230 / 255.0, 0.02);
  }
}

TEST(TraceTexture, of_a_transparent_picture_shows_where_that_is_opaque) {
  Context context;
  const Result<Image> picture = test::flat_picture(context, "gear", false, 0.5);
  ASSERT_TRUE(picture.ok());
  TraceOptions options = textured(120);
  TraceStats stats;
  const Document with = test::trace_of(*picture, options, &stats);
  options.has_texture = false;
  const Document without = test::trace_of(*picture, options);
  EXPECT_GE(*stats.textured_psnr_db, 50);
  EXPECT_EQ(with.shaders.size(), 2u);
  for (const Rgb ground : {Rgb{1, 1, 1}, Rgb{0, 0, 0}}) {
    EXPECT_GT(test::rendered_psnr_db(with, *picture, ground),
              test::rendered_psnr_db(without, *picture, ground));
  }
}

TEST(TraceTexture, of_nothing_to_be_seen_is_nothing) {
  const Image clear{2, 1, PixelFormat::rgba8, {9, 9, 9, 0, 200, 3, 9, 0}};
  const Document drawing = test::trace_of(clear, textured(0));
  EXPECT_GE(test::rendered_psnr_db(drawing, clear, {1, 1, 1}), 45);
  EXPECT_GE(test::rendered_psnr_db(drawing, clear, {0, 0, 0}), 45);
}

TEST(TraceTexture, of_one_pixel_has_its_color) {
  for (const std::uint8_t level : {0, 1, 127, 254, 255}) {
    const Image picture = pixel(PixelFormat::rgb8, {level, 128, 255});
    EXPECT_GE(test::rendered_psnr_db(test::trace_of(picture, textured(0)), picture), 48)
        << int{level};
  }
}

TEST(TraceTexture, has_the_same_bytes_for_any_threads_and_instructions) {
  const Image photo = test::synthetic_photo(90);
  const std::string expected = test::svg_of(test::trace_of(photo, textured(80)));
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    Context context{.executor = &pool};
    if (threads == 1) context.simd = SimdLevel::sse2;
    const Result<Document> drawing = trace(context, photo, textured(80));
    ASSERT_TRUE(drawing.ok()) << to_string(drawing.status());
    EXPECT_TRUE(test::svg_of(*drawing) == expected) << threads << " threads";
    EXPECT_EQ(context.budget.used(), 0u);
  }
}

TEST(TraceTexture, of_too_many_texels_is_a_limit) {
  Context context;
  context.limits.texels = 64 * 48 - 1;
  const Image photo = test::synthetic_photo(60);
  const Status status = trace(context, photo, textured(80)).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_EQ(status.limit, "texels");
  EXPECT_NE(status.message.find("texture"), std::string::npos) << status.message;
  EXPECT_EQ(context.budget.used(), 0u);
  context.limits.texels = 64 * 64;
  EXPECT_TRUE(trace(context, photo, textured(80)).ok());
}

TEST(TraceTexture, whose_file_would_be_too_long_is_a_limit) {
  const Document drawing = test::trace_of(test::synthetic_photo(60), textured(80));
  Context context;
  context.limits.input_bytes = 4000;
  const Status status = write_svg(context, drawing).status();
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_FALSE(status.message.empty());
}

TEST(TraceTexture, may_be_cancelled) {
  const Image photo = test::synthetic_photo(48);
  Context context;
  test::PollRecorder counter;
  context.poll_watch = &counter;
  ASSERT_TRUE(trace(context, photo, textured(40)).ok());
  for (std::uint64_t i = 1; i <= 12; ++i) {
    Context cancelled;
    CancelFlag& flag = cancelled.cancel;
    test::CancelAt watch(counter.polls() * (20 + i) / 32, flag);
    cancelled.poll_watch = &watch;
    EXPECT_EQ(trace(cancelled, photo, textured(40)).status().code, StatusCode::cancelled) << i;
    EXPECT_EQ(cancelled.budget.used(), 0u) << i;
  }
}

}  // namespace
}  // namespace sfumato
