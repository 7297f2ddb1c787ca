#include "gather/scene/far_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "support/cancel_at.hpp"

// The far field estimates the contribution of distant windows of thin layers.
namespace sfumato::gather::test {
namespace {

constexpr int kFarPoints = 300;

/// Returns the scene, charged to the context, which must outlive it.
Scene scene_of(Context& context, const Drawing& drawing, const GatherUse& use = {}) {
  Result<Scene> scene = build_scene(context, drawing.mesh, drawing.attributes, use);
  EXPECT_TRUE(scene.ok()) << scene.status().message;
  return std::move(*scene);
}

bool has_far_field(const Drawing& drawing, const GatherUse& use = {}) {
  Context context;
  return !scene_of(context, drawing, use).far_mean.empty();
}

/// Adds white squares with a door, `inside` of this kind, and removes specks that they would cross.
void add_rooms(std::vector<Line>& lines, double size, ShaderKind inside) {
  for (const Vec2 a : {Vec2{70, 80}, Vec2{300, 60}, Vec2{120, 330}, Vec2{350, 300}}) {
    Line room = plain_line({a + Vec2{size / 2, 0}, a, a + Vec2{0, size}, a + Vec2{size, size},
                            a + Vec2{size, 0}, a + Vec2{size * 3 / 4, 0}},
                           {1, 1, 1});
    room.left_kind = inside;
    std::erase_if(lines,
                  [&](const Line& line) { return distance_to_lines({room}, line.points[0]) < 1; });
    lines.push_back(std::move(room));
  }
}

Drawing specks_with_rooms(double size, ShaderKind inside) {
  std::vector<Line> lines = specks(4, 2000);
  add_rooms(lines, size, inside);
  return draw(lines);
}

void expect_near_reference(const Drawing& drawing, double rms, double largest,
                           int count = kFarPoints) {
  const std::vector<Vec2> points = random_points(drawing, 5, count, 0.5);
  Context context;
  const Difference d =
      difference(gather_at(context, drawing, points).value, reference_at(drawing, points));
  EXPECT_LE(d.rms, rms);
  EXPECT_LE(d.largest, largest);
}

TEST(FarField, stands_for_what_is_far_among_specks) {
  for (const int count : {1000, 4000}) {
    const Drawing drawing = draw(specks(1, count));
    EXPECT_TRUE(has_far_field(drawing));
    expect_near_reference(drawing, 0.1, 0.5);
  }
}

TEST(FarField, does_not_change_a_layer_of_one_colour) {
  std::vector<Line> lines = specks(3, 2000);
  for (Line& line : lines) line = plain_line(line.points, {0.75f, 0.5f, 0.25f});
  const Drawing drawing = draw(lines);
  const std::vector<Vec2> points = random_points(drawing, 3, kFarPoints, 0.5);
  ASSERT_TRUE(has_far_field(drawing));
  Context context;
  const std::vector<float> value = gather_at(context, drawing, points).value;
  for (std::size_t i = 0; i < value.size(); ++i) {
    EXPECT_NEAR(value[i], 0.75f - 0.25f * static_cast<float>(i % 3), 1e-5f) << i;
  }
}

TEST(FarField, stands_for_small_rooms_too) {
  for (const ShaderKind inside : {ShaderKind::curve_domain, ShaderKind::barrier}) {
    const Drawing drawing = specks_with_rooms(8, inside);
    EXPECT_TRUE(has_far_field(drawing));
    expect_near_reference(drawing, 0.1, 0.5);
  }
}

TEST(FarField, is_not_there_where_walls_stand_among_specks) {
  for (const ShaderKind inside : {ShaderKind::curve_domain, ShaderKind::barrier}) {
    const Drawing drawing = specks_with_rooms(80, inside);
    EXPECT_FALSE(has_far_field(drawing));
    expect_near_reference(drawing, 0.3, 1);
  }
}

TEST(FarField, knows_the_shaders_of_sides) {
  const Drawing drawing = draw(with_blends(specks(5, 2000), 5, 0, 3));
  EXPECT_TRUE(has_far_field(drawing));
  expect_near_reference(drawing, 0.1, 0.5);
}

TEST(FarField, is_not_asked_within_blur_radii) {
  for (const float radius : {4.0f, 40.0f}) {
    const Drawing drawing = draw(with_blends(specks(6, 1000), 6, radius, 3));
    EXPECT_TRUE(has_far_field(drawing));
    expect_near_reference(drawing, 0.1, 0.5, 40);
  }
}

TEST(FarField, tells_the_weights_of_curves) {
  std::vector<Line> lines = specks(7, 2000);
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].weight = i % 2 == 0 ? 8.0f : 1.0f;
  const Drawing drawing = draw(lines);
  EXPECT_TRUE(has_far_field(drawing));
  expect_near_reference(drawing, 0.15, 0.6);
}

TEST(FarField, has_four_channels_as_it_has_three_and_one) {
  Drawing drawing = draw(specks(8, 2000));
  for (auto* sides : {&drawing.attributes.left, &drawing.attributes.right}) {
    for (curves::SegmentSide& side : *sides) {
      side.value.start.channel[3] = side.value.start.channel[1];
      side.value.end.channel[3] = side.value.end.channel[1];
    }
  }
  const std::vector<Vec2> points = random_points(drawing, 8, kFarPoints, 0.5);
  Context context;
  const std::vector<float> colors = gather_at(context, drawing, points).value;
  drawing.attributes.base_channels = 1;
  const std::vector<float> one = gather_at(context, drawing, points).value;
  drawing.attributes.base_channels = 4;
  const std::vector<float> both = gather_at(context, drawing, points).value;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one[i], colors[3 * i]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(both[4 * i + c], colors[3 * i + c]);
    EXPECT_EQ(both[4 * i + 3], colors[3 * i + 1]);
  }
}

TEST(FarField, gives_the_same_bytes_for_any_instruction_set_and_threads) {
  for (const std::uint32_t shaders : {0u, 2u}) {
    const std::vector<Line> lines = specks(9, 1500);
    const Drawing drawing = draw(shaders > 0 ? with_blends(lines, 9, 8, shaders) : lines);
    ASSERT_TRUE(has_far_field(drawing));
    const std::vector<Vec2> points = random_points(drawing, 9, 2003, 0);
    Context context;
    context.simd = SimdLevel::sse2;
    const Gathered expected = gather_at(context, drawing, points);
    ThreadPool executor(3);
    context.executor = &executor;
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      context.simd = level;
      const Gathered gathered = gather_at(context, drawing, points);
      EXPECT_EQ(gathered.value, expected.value) << static_cast<int>(level);
      EXPECT_EQ(gathered.hit, expected.hit);
    }
  }
}

TEST(FarField, is_not_there_where_curves_are_few_or_stop_most_rays) {
  EXPECT_FALSE(has_far_field(draw(specks(10, 200))));
  EXPECT_FALSE(has_far_field(draw(random_lines(10, 300, 0.1, 0.1))));
  std::vector<Line> mosaic;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      const Vec2 a{16.0 + 24 * i, 16.0 + 24 * k};
      mosaic.push_back(plain_line({a, a + Vec2{24, 0}}, {1, 0, 0}));
      mosaic.push_back(plain_line({a, a + Vec2{0, 24}}, {0, 0, 1}));
    }
  }
  EXPECT_FALSE(has_far_field(draw(mosaic)));
}

TEST(FarField, is_not_there_where_it_is_asked_who_sees_a_curve) {
  const Drawing drawing = draw(specks(11, 1000));
  EXPECT_TRUE(has_far_field(drawing));
  EXPECT_FALSE(has_far_field(drawing, {.will_be_extended = true}));
  const std::vector<std::uint8_t> watched(drawing.attributes.weight.size(), 1);
  EXPECT_FALSE(has_far_field(drawing, {.is_watched = watched}));
}

TEST(FarField, tells_the_nearest_direction) {
  for (int i = 0; i < 3600; ++i) {
    const double angle = (i + 0.25) * std::numbers::pi / 1800;
    const auto expected = static_cast<int>(std::lround(8 * angle / std::numbers::pi)) % 16;
    EXPECT_EQ(
        far_direction(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))),
        expected)
        << angle;
  }
}

/// Returns the scene of build_scene before the far field is added.
Scene without_far_field(const Scene& scene) {
  Scene copy;
  copy.triangle = scene.triangle;
  copy.hit_edge = scene.hit_edge;
  return copy;
}

TEST(FarField, ends_when_it_is_cancelled) {
  Context own;
  const Scene scene = scene_of(own, draw(specks(12, 1000)));
  std::uint64_t poll = 1;
  for (;; poll += 97) {
    Context context;
    Scene again = without_far_field(scene);
    sfumato::test::CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Status status = add_far_field(context, again);
    if (status) {
      EXPECT_EQ(again.far_mean, scene.far_mean);
      break;
    }
    EXPECT_EQ(status.code, StatusCode::cancelled);
  }
  EXPECT_GT(poll, 1000u);
}

TEST(FarField, is_charged) {
  Context own;
  const Scene scene = scene_of(own, draw(specks(12, 1000)));
  const std::size_t bytes = scene.far_mean.size() * sizeof(float);
  for (const std::size_t room : {bytes - 1, bytes}) {
    Context context{.budget = Budget(room)};
    Scene again = without_far_field(scene);
    const Status status = add_far_field(context, again);
    EXPECT_EQ(status.ok(), room == bytes);
    EXPECT_EQ(status.limit, room == bytes ? "" : "memory");
  }
}

}  // namespace
}  // namespace sfumato::gather::test
