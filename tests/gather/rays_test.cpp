#include <gtest/gtest.h>

#include <cmath>

#include "gather/scene/ray_grid.hpp"
#include "gather/scenes.hpp"

namespace sfumato::gather::test {
namespace {

TEST(Rays, many_rays_approach_the_exact_gather) {
  for (std::uint32_t seed = 70; seed < 72; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 100, 0.15, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 24, 2);
    Context context;
    const Gathered exact = gather_at(context, drawing, points);
    // 4,096 rays at a time, then the mean of sixteen times as many.
    std::vector<float> mean(exact.value.size(), 0.0f);
    for (std::uint64_t run = 0; run < 16; ++run) {
      const Gathered rays = gather_at(context, drawing, points,
                                      {.method = Method::rays, .rays_per_node = 4096, .seed = run});
      EXPECT_LE(difference(rays.value, exact.value).rms, 0.3);
      EXPECT_EQ(rays.hit, exact.hit);
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += rays.value[i] / 16;
    }
    EXPECT_LE(difference(mean, exact.value).rms, 0.06);
  }
}

TEST(Rays, a_closed_loop_is_hit_by_every_ray) {
  Line loop = plain_line({}, {});
  for (int i = 0; i <= 60; ++i) {
    const double angle = 6.283185307179586 * (i % 60) / 60;
    loop.points.push_back(
        {std::round(256 + 230 * std::cos(angle)), std::round(256 + 230 * std::sin(angle))});
  }
  loop.left.assign(loop.points.size(), {});
  loop.right.assign(loop.points.size(), {1, 1, 1});
  const Drawing drawing = draw({loop});
  Context context;
  const Result<Scene> scene = build_scene(context, drawing.mesh, drawing.attributes);
  const Result<RayGrid> grid = RayGrid::create(context, *scene);
  ASSERT_TRUE(grid.ok());
  const Vec2 p = Vec2{300, 200} - scene->origin;
  for (int i = 0; i < 100000; ++i) {
    const double angle = i * 6.283185307179586 / 100000;
    const RayHit hit =
        grid->first_hit(static_cast<float>(p.x), static_cast<float>(p.y),
                        static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    ASSERT_TRUE(hit.edge) << angle;
    EXPECT_EQ(hit.edge->middle[0], 1);
    EXPECT_LE(hit.distance, 302);
  }
}

TEST(Rays, the_seed_changes_the_noise_and_nothing_else_does) {
  const Drawing drawing = draw(random_lines(74, 60, 0, 0));
  const std::vector<Vec2> points = random_points(drawing, 74, 200, 1);
  Context context;
  const auto with_seed = [&](std::uint64_t seed) {
    return gather_at(context, drawing, points,
                     {.method = Method::rays, .rays_per_node = 16, .seed = seed})
        .value;
  };
  EXPECT_EQ(with_seed(1), with_seed(1));
  EXPECT_NE(with_seed(1), with_seed(2));
}

TEST(Rays, noise_is_unbiased_over_seeds) {
  const Drawing drawing = draw({plain_line({{64, 64}, {448, 64}}, {1, 1, 1}),
                                plain_line({{64, 448}, {448, 448}}, {0, 0, 0})});
  Context context;
  const std::vector<Vec2> points{{250, 200}};
  const float exact = gather_at(context, drawing, points).value[0];
  double mean = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    mean += gather_at(context, drawing, points,
                      {.method = Method::rays, .rays_per_node = 256, .seed = seed})
                .value[0] /
            200.0;
  }
  EXPECT_NEAR(mean, exact, 1e-3);
}

TEST(Rays, a_number_of_rays_out_of_range_is_a_limit_error) {
  const Drawing drawing = draw(random_lines(75, 5, 0, 0));
  Context context;
  const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  ASSERT_TRUE(gatherer.ok());
  const std::vector<Vec2> points{{10, 10}};
  std::vector<float> out(3);
  for (int rays : {0, -1, limits::kRays + 1}) {
    EXPECT_EQ(
        gatherer->gather(context, points, {.method = Method::rays, .rays_per_node = rays}, out)
            .code,
        StatusCode::limit);
  }
}

TEST(Visibility, open_sides_are_seen_through_and_barriers_are_not) {
  // A white line behind a wall whose facing side is open, a barrier, or coloured.
  Line wall = plain_line({{64, 256}, {448, 256}}, {1, 0, 0});
  const Line white = plain_line({{16, 128}, {496, 128}}, {1, 1, 1});
  const std::vector<Vec2> below{{256, 257}};
  for (Method method : {Method::exact, Method::rays}) {
    Context context;
    const GatherOptions options{.method = method, .rays_per_node = 1024, .seed = 0};
    // The side below a line that runs right is its right side.
    wall.right_kind = ShaderKind::open;
    Gathered gathered = gather_at(context, draw({white, wall}), below, options);
    EXPECT_NEAR(gathered.value[1], 1, 1e-5);
    EXPECT_EQ(gathered.hit[0], 1);
    wall.right_kind = ShaderKind::curve_domain;
    gathered = gather_at(context, draw({white, wall}), below, options);
    EXPECT_NEAR(gathered.value[1], 0, 1e-3);
    wall.right_kind = ShaderKind::barrier;
    gathered = gather_at(context, draw({wall}), below, options);
    EXPECT_EQ(gathered.hit[0], 0);
    EXPECT_EQ(gathered.value, (std::vector<float>{0, 0, 0}));
  }
}

TEST(Visibility, a_barrier_hides_what_is_behind_it) {
  Line wall = plain_line({{8, 256}, {504, 256}}, {1, 0, 0});
  wall.right_kind = ShaderKind::barrier;
  const Line white = plain_line({{200, 200}, {300, 200}}, {1, 1, 1});
  const Line green = plain_line({{200, 500}, {300, 500}}, {0, 1, 0});
  for (Method method : {Method::exact, Method::rays}) {
    Context context;
    const Gathered gathered = gather_at(context, draw({white, green, wall}), {{256, 260}},
                                        {.method = method, .rays_per_node = 1024, .seed = 0});
    EXPECT_NEAR(gathered.value[0], 0, 1e-6);
    EXPECT_NEAR(gathered.value[1], 1, 1e-6);
  }
}

}  // namespace
}  // namespace sfumato::gather::test
