#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "gather/gather_reference.hpp"
#include "gather/kernels/kernel.hpp"
#include "gather/kernels/kernel_entry.hpp"
#include "gather/reference_weights.hpp"
#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::gather::test {
namespace {

/// The visible set by sorted end points and one ray in every gap: no mesh, O(n²).
class BruteForce {
 public:
  explicit BruteForce(const std::vector<Line>& lines) : lines_(lines) {}

  std::array<double, 3> value(Vec2 p) const {
    std::vector<double> angles;
    for (const Line& line : lines_) {
      for (Vec2 q : line.points) angles.push_back(std::atan2(q.y - p.y, q.x - p.x));
    }
    std::sort(angles.begin(), angles.end());
    ReferenceSums sums;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
      if (next - angles[i] > 1e-12) add_gap(p, angles[i], next, sums);
    }
    return sums.value();
  }

 private:
  static Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

  static const curves::SegmentValues<Rgb> side_color(const Line& line, bool left) {
    return left ? curves::SegmentValues<Rgb>{line.left[0], line.left[1]}
                : curves::SegmentValues<Rgb>{line.right[0], line.right[1]};
  }

  void add_gap(Vec2 p, double from, double to, ReferenceSums& sums) const {
    const Vec2 ray = unit((from + to) / 2);
    const Line* first = nullptr;
    double least = 1e300;
    for (const Line& line : lines_) {
      const Vec2 a = line.points[0] - p, b = line.points[1] - p;
      const double before = cross(ray, a), after = cross(ray, b);
      if ((before > 0) == (after > 0)) continue;
      const bool left = cross(b - a, Vec2{} - a) < 0;
      if ((left ? line.left_kind : line.right_kind) == ShaderKind::open) continue;
      const double distance = dot(lerp(a, b, before / (before - after)), ray);
      if (distance <= 0 || distance >= least) continue;
      least = distance;
      first = &line;
    }
    if (first) integrate(p, *first, unit(from), unit(to), sums);
  }

  static void integrate(Vec2 p, const Line& line, Vec2 from, Vec2 to, ReferenceSums& sums) {
    const Vec2 a = line.points[0] - p, b = line.points[1] - p;
    const bool left = cross(b - a, Vec2{} - a) < 0;
    if ((left ? line.left_kind : line.right_kind) != ShaderKind::curve_domain) return;
    const auto cut = [&](Vec2 ray) {
      return std::clamp(cross(ray, a) / -cross(ray, b - a), 0.0, 1.0);
    };
    const double t1 = cut(from), t2 = cut(to);
    const ReferenceWeights w = reference_weights(lerp(a, b, t1), lerp(a, b, t2));
    const auto color = side_color(line, left);
    const Rgb c1 = lerp(color.start, color.end, static_cast<float>(t1));
    const Rgb c2 = lerp(color.start, color.end, static_cast<float>(t2));
    const double k = line.weight;
    sums.weight += k * (w.right + w.left);
    sums.color[0] += k * (w.right * c1.r + w.left * c2.r);
    sums.color[1] += k * (w.right * c1.g + w.left * c2.g);
    sums.color[2] += k * (w.right * c1.b + w.left * c2.b);
  }

  const std::vector<Line>& lines_;
};

std::vector<SimdLevel> available_levels() {
  std::vector<SimdLevel> levels;
  for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
    if (level <= detected_simd_level()) levels.push_back(level);
  }
  return levels;
}

TEST(ExactGather, reference_is_the_brute_force_over_all_segments) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 60, 0.2, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 200, 0.05);
    const std::vector<float> values = reference_at(drawing, points);
    const BruteForce brute_force(drawing.lines);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::array<double, 3> expected = brute_force.value(points[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(values[3 * i + c], expected[c], 1e-6) << seed << ' ' << i;
      }
    }
  }
}

TEST(ExactGather, packets_give_the_reference_on_random_scenes) {
  for (std::uint32_t seed = 10; seed < 30; ++seed) {
    const int count = 10 + static_cast<int>(seed % 5) * 60;
    const Drawing drawing = draw(random_lines(seed, count, 0.15, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 1000, 0.05);
    Context context;
    const Gathered gathered = gather_at(context, drawing, points);
    const Difference d = difference(gathered.value, reference_at(drawing, points));
    EXPECT_LE(d.rms, 2e-3) << seed;
    EXPECT_LE(d.largest, 0.03) << seed;
  }
}

// A point sees mostly distant curves here: windows wait until all near ones are integrated. With
// more specks there is a far field (far_field_test.cpp).
TEST(ExactGather, packets_give_the_reference_among_specks) {
  for (const int count : {30, 100, 250}) {
    const Drawing drawing = draw(specks(7, count));
    const std::vector<Vec2> points = random_points(drawing, 7, 500, 0.05);
    Context context;
    const Gathered gathered = gather_at(context, drawing, points);
    const Difference d = difference(gathered.value, reference_at(drawing, points));
    EXPECT_LE(d.rms, 0.05) << count;
    EXPECT_LE(d.largest, 0.2) << count;
    for (SimdLevel level : available_levels()) {
      context.simd = level;
      EXPECT_EQ(gather_at(context, drawing, points).value, gathered.value);
    }
  }
}

TEST(ExactGather, bytes_do_not_depend_on_the_instruction_set) {
  for (std::uint32_t seed = 40; seed < 45; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 150, 0.15, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 2003, 0);
    Context context;
    context.simd = SimdLevel::sse2;
    const Gathered expected = gather_at(context, drawing, points);
    for (SimdLevel level : available_levels()) {
      context.simd = level;
      const Gathered gathered = gather_at(context, drawing, points);
      EXPECT_EQ(gathered.hit, expected.hit);
      EXPECT_EQ(std::memcmp(gathered.value.data(), expected.value.data(),
                            expected.value.size() * sizeof(float)),
                0)
          << "seed " << seed << " level " << static_cast<int>(level);
    }
  }
}

TEST(ExactGather, bytes_do_not_depend_on_the_number_of_threads) {
  const Drawing drawing = draw(random_lines(50, 200, 0.15, 0.1));
  const std::vector<Vec2> points = random_points(drawing, 50, 5000, 0);
  for (Method method : {Method::exact, Method::rays}) {
    const GatherOptions options{.method = method, .rays_per_node = 16, .seed = 7};
    Context alone;
    const Gathered expected = gather_at(alone, drawing, points, options);
    for (int threads : {1, 2, 3, 8}) {
      ThreadPool executor(threads);
      Context context;
      context.executor = &executor;
      const Gathered gathered = gather_at(context, drawing, points, options);
      EXPECT_EQ(gathered.value, expected.value) << threads;
      EXPECT_EQ(gathered.hit, expected.hit) << threads;
    }
  }
}

TEST(ExactGather, one_lane_at_a_time_gives_the_bits_of_the_packet) {
  // A fan of one triangle inside a square that stops rays.
  const HitEdge stops[] = {{
                               .ax = -8,
                               .ay = -8,
                               .bx = 8,
                               .by = -8,
                               .ex = 16,
                               .ey = 0,
                               .length_squared = 256,
                               .weight = 1,
                               .middle = {0.5f, 0.5f, 0},
                               .half_change = {-0.5f, 0.5f, 0},
                           },
                           {
                               .ax = 8,
                               .ay = -8,
                               .bx = 0,
                               .by = 8,
                               .ex = -8,
                               .ey = 16,
                               .length_squared = 320,
                               .weight = 0.5f,
                               .middle = {0, 0.25f, 0.375f},
                               .half_change = {0, 0.25f, -0.125f},
                           },
                           {
                               .ax = 0,
                               .ay = 8,
                               .bx = -8,
                               .by = -8,
                               .ex = -8,
                               .ey = -16,
                               .length_squared = 320,
                               .weight = 1,
                               .middle = {0.5f, 0.5f, 0},
                               .half_change = {0.5f, -0.5f, 0},
                           }};
  const SceneTriangle triangle{.x = {-8, 8, 0},
                               .y = {-8, -8, 8},
                               .edge = {hit_code(0), hit_code(1), hit_code(2)},
                               .twin = {-1, -1, -1}};
  const SceneView scene{nullptr, stops, nullptr, 3, 0, &triangle, 1000};
  const PacketTriangle member{0, 0, 0, kPacketLanes, 0, 0, 0};
  PacketInput input{&member, 1, {}, {}};
  for (int i = 0; i < kPacketLanes; ++i) {
    input.x[i] = -3.0f + 0.37f * static_cast<float>(i);
    input.y[i] = -7.5f + 0.41f * static_cast<float>(i);
  }
  std::vector<StackSlot> slots(kPacketStackLeast);
  const PacketStack stack{slots.data(), kPacketStackLeast};
  PacketResult one{}, four{};
  ASSERT_TRUE(gather_packets<1>(scene, {&input, &one, 1}, stack));
  ASSERT_TRUE(packet_kernel(SimdLevel::sse2)(scene, {&input, &four, 1}, stack));
  EXPECT_EQ(std::memcmp(&one, &four, sizeof(one)), 0);
  EXPECT_GT(one.weight[0], 0);
}

TEST(ExactGather, points_on_vertices_edges_and_lines_are_finite_and_in_range) {
  const Drawing drawing = draw(random_lines(60, 120, 0.15, 0.1));
  std::vector<Vec2> points = drawing.mesh.vertex_position;
  for (std::uint32_t h = 0; h < drawing.mesh.triangle_vertex.size(); ++h) {
    const Vec2 a = drawing.mesh.vertex_position[drawing.mesh.origin(h)];
    const Vec2 b = drawing.mesh.vertex_position[drawing.mesh.target(h)];
    for (double t : {0.5, 1.0 / 3, 1e-7, 1e-12}) points.push_back(lerp(a, b, t));
  }
  points.push_back(drawing.frame.min);
  points.push_back({1e7, -1e7});
  for (Method method : {Method::exact, Method::rays}) {
    Context context;
    const Gathered gathered =
        gather_at(context, drawing, points, {.method = method, .rays_per_node = 16, .seed = 1});
    for (float value : gathered.value) {
      EXPECT_TRUE(std::isfinite(value));
      EXPECT_GE(value, -1e-5f);
      EXPECT_LE(value, 1 + 1e-5f);
    }
  }
}

TEST(ExactGather, a_point_on_a_line_takes_the_colour_of_one_of_its_sides) {
  Line line{.points = {{64, 64}, {448, 64}},
            .left = {{0, 0, 0}, {1, 0, 0}},
            .right = {{0, 0, 1}, {1, 0, 1}}};
  const Drawing drawing = draw({line, plain_line({{64, 300}, {448, 300}}, {0, 1, 0})});
  Context context;
  const Gathered gathered = gather_at(context, drawing, {{160, 64}, {256, 64}});
  EXPECT_NEAR(gathered.value[0], 0.25, 1e-4);
  EXPECT_NEAR(gathered.value[1], 0, 1e-4);
  EXPECT_NEAR(gathered.value[3], 0.5, 1e-4);
}

TEST(ExactGather, a_waiting_window_for_every_tooth_of_a_comb_finds_room) {
  // From the left, every tooth's tip interrupts the view, and all gaps wait at the same time.
  std::vector<Line> lines;
  for (int i = 0; i < 1200; ++i) {
    const double x = 16 + i * 0.375;
    lines.push_back(
        plain_line({{x, 500}, {x, 260 + std::floor(0.004 * (x - 16) * (x - 16) * 16) / 64}},
                   {static_cast<float>(i % 7) / 7, 0.5f, 0}));
  }
  const Drawing drawing = draw(std::move(lines));
  const std::vector<Vec2> points{{5, 30}, {5.5, 30}, {6, 31}, {256, 20}, {500, 10}};
  Context context;
  const Gathered gathered = gather_at(context, drawing, points);
  EXPECT_LE(difference(gathered.value, reference_at(drawing, points)).largest, 0.02);
}

TEST(ExactGather, memory_is_charged_and_given_back) {
  const Drawing drawing = draw(random_lines(61, 50, 0, 0));
  const std::vector<Vec2> points = random_points(drawing, 61, 2000, 0.1);
  Context context;
  {
    const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
    ASSERT_TRUE(gatherer.ok());
    EXPECT_GT(context.budget.used(), drawing.mesh.triangle_vertex.size() * 16);
    std::vector<float> out(3 * points.size());
    ASSERT_TRUE(gatherer->gather(context, points, {}, out).ok());
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(ExactGather, a_small_budget_is_a_limit_error) {
  const Drawing drawing = draw(random_lines(61, 50, 0, 0));
  const std::vector<Vec2> points = random_points(drawing, 61, 20000, 0.1);
  Context context;
  const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  ASSERT_TRUE(gatherer.ok());
  std::vector<float> out(3 * points.size());
  Context poor;
  ASSERT_TRUE(poor.budget.charge(poor.budget.limit() - 1000, "the rest").ok());
  EXPECT_EQ(gatherer->gather(poor, points, {}, out).code, StatusCode::limit);
  EXPECT_EQ(Gatherer::create(poor, drawing.mesh, drawing.attributes).status().code,
            StatusCode::limit);
}

TEST(ExactGather, cancellation_is_seen) {
  const Drawing drawing = draw(random_lines(61, 50, 0, 0));
  const std::vector<Vec2> points = random_points(drawing, 61, 2000, 0.1);
  Context context;
  const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  ASSERT_TRUE(gatherer.ok());
  std::vector<float> out(3 * points.size());
  context.cancel = true;
  EXPECT_EQ(gatherer->gather(context, points, {}, out).code, StatusCode::cancelled);
  EXPECT_EQ(gatherer->gather(context, points, {.method = Method::rays}, out).code,
            StatusCode::cancelled);
}

TEST(ExactGather, no_points_and_no_lines_are_fine) {
  const Drawing drawing = draw({});
  Context context;
  EXPECT_TRUE(gather_at(context, drawing, {}).value.empty());
  const Gathered gathered = gather_at(context, drawing, {{100, 100}});
  EXPECT_EQ(gathered.hit, std::vector<std::uint8_t>{0});
  EXPECT_EQ(gathered.value, (std::vector<float>{0, 0, 0}));
}

}  // namespace
}  // namespace sfumato::gather::test
