#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"

// Blur radii and image-domain shaders (paper eq. 4–11).
namespace sfumato::gather::test {
namespace {

std::vector<Line> widely_blended_lines(std::uint32_t seed) {
  return with_blends(random_lines(seed, 80, 0.1, 0.1), seed, 40, 5);
}

TEST(Blends, the_packets_agree_with_the_reference) {
  for (std::uint32_t seed = 200; seed < 204; ++seed) {
    const Drawing drawing = draw(widely_blended_lines(seed));
    const std::vector<Vec2> points = random_points(drawing, seed, 400, 0.5);
    Context context;
    const Difference d =
        difference(gather_at(context, drawing, points).value, reference_at(drawing, points));
    // Radii that change by less than 1/32 are not integrated: 0.0007 of the contrast.
    EXPECT_LE(d.rms, 8e-3);
    EXPECT_LE(d.largest, 0.25);
  }
}

/// Returns the mean of 16 runs of 4096 rays.
std::vector<float> many_rays(const Drawing& drawing, const std::vector<Vec2>& points) {
  Context context;
  std::vector<float> mean;
  for (std::uint64_t run = 0; run < 16; ++run) {
    const Gathered rays = gather_at(context, drawing, points,
                                    {.method = Method::rays, .rays_per_node = 4096, .seed = run});
    mean.resize(rays.value.size(), 0.0f);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += rays.value[i] / 16;
  }
  return mean;
}

TEST(Blends, rays_with_the_same_beta_approach_the_exact_gather) {
  const Drawing drawing = draw(widely_blended_lines(210));
  const std::vector<Vec2> points = random_points(drawing, 210, 48, 2);
  Context context;
  const Gathered exact = gather_at(context, drawing, points);
  EXPECT_LE(difference(many_rays(drawing, points), exact.value).rms, 0.1);
}

/// Returns a line of `size`, red and blue, whose radius runs from `from` to `to`, in a white
/// square.
Drawing growing_line(double size, float from, float to) {
  Line line{.points = {{256, 256}, {256 + size, 256 + size / 4}},
            .left = {{1, 0, 0}, {1, 1, 0}},
            .right = {{0, 0, 1}, {0, 1, 1}}};
  line.weight = 4;
  line.blur_radius = {from, to};
  Line around = plain_line({{2, 2}, {510, 2}, {510, 510}, {2, 510}, {2, 2}}, kWhite);
  return draw({line, around});
}

/// Returns points near the line, also close to its ends and beyond them.
std::vector<Vec2> points_near(double size) {
  std::vector<Vec2> points;
  for (double along : {-1.0, -0.05, 0.01, 0.1, 0.35, 0.6, 0.9, 0.99, 1.02, 1.5, 4.0}) {
    for (double off : {-1.5, -0.6, -0.2, -0.03, 0.005, 0.1, 0.4, 1.2}) {
      const Vec2 p{256 + size * (along - off / 4), 256 + size * (along / 4 + off)};
      if (p.x > 4 && p.x < 508 && p.y > 4 && p.y < 508) points.push_back(p);
    }
  }
  return points;
}

// The bound of docs/mathematics.md is 0.001 of the contrast, a quarter of a code value. The
// reference itself has an error of a tenth of that.
TEST(Blends, a_radius_that_varies_is_integrated_along_the_line) {
  for (double size : {1.0, 16.0, 200.0}) {
    for (auto [from, to] : {std::pair{0.0f, 60.0f},
                            {60.0f, 0.0f},
                            {3.0f, 40.0f},
                            {0.0f, 0.5f},
                            {0.0f, 500.0f},
                            {500.0f, 20.0f}}) {
      const Drawing drawing = growing_line(size, from, to);
      const std::vector<Vec2> points = points_near(size);
      Context context;
      const Difference d =
          difference(gather_at(context, drawing, points).value, reference_at(drawing, points));
      EXPECT_LE(d.largest, 0.28) << size << ": " << from << " to " << to;
    }
  }
}

TEST(Blends, a_radius_that_varies_gives_what_65536_rays_give) {
  for (auto [from, to] : {std::pair{0.0f, 60.0f}, {60.0f, 5.0f}, {0.0f, 500.0f}}) {
    const Drawing drawing = growing_line(160, from, to);
    const std::vector<Vec2> points = points_near(160);
    Context context;
    const Difference d =
        difference(gather_at(context, drawing, points).value, many_rays(drawing, points));
    EXPECT_LE(d.rms, 0.1) << from << " to " << to;
    EXPECT_LE(d.largest, 0.5) << from << " to " << to;
  }
}

TEST(Blends, every_width_and_thread_count_gives_the_same_bits) {
  const Drawing drawing = draw(widely_blended_lines(211));
  const std::vector<Vec2> points = random_points(drawing, 211, 3000, 0.1);
  Context plain;
  plain.simd = SimdLevel::sse2;
  const std::vector<float> expected = gather_at(plain, drawing, points).value;
  for (int threads : {1, 3}) {
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      ThreadPool pool(threads);
      Context context;
      context.executor = &pool;
      context.simd = level;
      EXPECT_EQ(gather_at(context, drawing, points).value, expected);
    }
  }
}

TEST(Blends, white_sides_and_shares_of_shaders_sum_to_one) {
  std::vector<Line> lines = with_blends(random_lines(212, 80, 0.1, 0), 212, 60, 6);
  for (Line& line : lines) {
    line.left.assign(2, kWhite);
    line.right.assign(2, kWhite);
  }
  const Drawing drawing = draw(std::move(lines));
  const auto channels = static_cast<std::size_t>(drawing.attributes.channel_count());
  const std::vector<Vec2> points = random_points(drawing, 212, 1000, 0.1);
  Context context;
  const Gathered gathered = gather_at(context, drawing, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = gathered.value[channels * i];
    for (std::size_t c = 3; c < channels; ++c) sum += gathered.value[channels * i + c];
    EXPECT_NEAR(sum, 1, 1e-5);
  }
}

TEST(Blends, a_scene_of_one_shader_gives_it_the_whole_weight) {
  Line line = plain_line({{100, 100}, {300, 140}}, kWhite);
  line.left_kind = line.right_kind = ShaderKind::image_domain;
  line.blur_radius = {20, 30};
  const Drawing drawing = draw({line});
  Context context;
  const Gathered gathered = gather_at(context, drawing, random_points(drawing, 3, 200, 0.1));
  for (std::size_t i = 0; i < gathered.value.size(); i += 4) {
    EXPECT_EQ(gathered.value[i], 0);
    EXPECT_NEAR(gathered.value[i + 3], 1, 1e-6);
  }
}

/// Returns a long line, white above (on its left), black below; the frame's far sides see nothing
/// else.
Drawing long_line(curves::SegmentValues<float> radius) {
  Line line = plain_line({{16, 256}, {496, 256}}, kWhite);
  line.right.assign(2, kBlack);
  line.blur_radius = radius;
  return draw({line});
}

double value_above(const Drawing& drawing, double distance) {
  Context context;
  return gather_at(context, drawing, {{256, 256 - distance}}).value[0];
}

TEST(Blends, the_transition_across_a_line_is_smoothstep) {
  const Drawing drawing = long_line({24, 24});
  for (double d : {0.5, 3.0, 8.0, 12.0, 20.0, 23.9, 24.1, 60.0}) {
    const double x = std::min((d + 24) / 48, 1.0);
    EXPECT_NEAR(value_above(drawing, d), x * x * (3 - 2 * x), 1e-5) << d;
    EXPECT_NEAR(value_above(drawing, -d), 1 - x * x * (3 - 2 * x), 1e-5) << d;
  }
}

TEST(Blends, the_normal_derivative_is_three_quarters_of_the_jump_over_the_radius) {
  for (float radius : {4.0f, 16.0f, 48.0f}) {
    const Drawing drawing = long_line({radius, radius});
    const double h = radius / 200.0;
    const double slope = (value_above(drawing, h) - value_above(drawing, -h)) / (2 * h);
    EXPECT_NEAR(slope, 3.0 / (4 * radius), 1e-3 / radius);
  }
}

TEST(Blends, a_radius_of_zero_is_a_sharp_side) {
  const Drawing sharp = long_line({0, 0});
  EXPECT_EQ(value_above(sharp, 1e-2), 1);
  EXPECT_EQ(value_above(sharp, -1e-2), 0);
}

TEST(Blends, without_a_shader_behind_there_is_nothing_to_blur_with) {
  Line line = plain_line({{16, 256}, {496, 256}}, kWhite);
  line.right_kind = ShaderKind::open;
  line.blur_radius = {30, 30};
  const Drawing drawing = draw({line});
  EXPECT_EQ(value_above(drawing, 1), 1);
}

TEST(Blends, each_side_follows_its_own_radius) {
  Drawing drawing = long_line({10, 10});
  for (auto& side : drawing.attributes.right) side.blur_radius = {40, 40};
  const double above = (value_above(drawing, 0.05) - 0.5) / 0.05;
  const double below = (0.5 - value_above(drawing, -0.05)) / 0.05;
  EXPECT_NEAR(above, 3.0 / (4 * 10), 1e-3);
  EXPECT_NEAR(below, 3.0 / (4 * 40), 1e-3);
}

}  // namespace
}  // namespace sfumato::gather::test
