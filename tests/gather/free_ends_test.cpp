#include "gather/ends/free_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "gather/gather_reference.hpp"
#include "gather/kernels/end_terms.hpp"
#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"

// The term of free ends (docs/mathematics.md).
namespace sfumato::gather::test {
namespace {

Line two_sided(std::vector<Vec2> points) {
  Line line = plain_line(std::move(points), kWhite);
  line.right.assign(line.points.size(), kBlack);
  return line;
}

Gathered soft_at(Context& context, const Drawing& drawing, const std::vector<Vec2>& points,
                 const GatherOptions& options = {}) {
  Gathered result{std::vector<float>(drawing.attributes.channel_count() * points.size(), -1.0f),
                  std::vector<std::uint8_t>(points.size(), 7)};
  const Result<Gatherer> gatherer =
      Gatherer::create(context, drawing.mesh, drawing.attributes, Ends::soft);
  EXPECT_TRUE(gatherer.ok()) << gatherer.status().message;
  if (!gatherer) return result;
  const Status status = gatherer->gather(context, points, options, result.value, result.hit);
  EXPECT_TRUE(status.ok()) << status.message;
  return result;
}

std::vector<FreeEnd> ends_of(const Drawing& drawing) {
  Context context;
  TableMemory memory("a test");
  Result<std::vector<FreeEnd>> ends =
      find_free_ends(context, drawing.mesh, drawing.attributes, memory);
  EXPECT_TRUE(ends.ok());
  return ends ? std::move(*ends) : std::vector<FreeEnd>{};
}

std::vector<float> soft_reference_at(const Drawing& drawing, const std::vector<Vec2>& points) {
  const std::vector<FreeEnd> ends = ends_of(drawing);
  std::vector<float> values;
  for (Vec2 p : points) {
    const auto triangle = static_cast<std::uint32_t>(find_triangle(drawing.mesh, p));
    const ReferenceSums sums =
        gather_reference(drawing.mesh, drawing.attributes, p, triangle, ends);
    for (double value : sums.value()) values.push_back(static_cast<float>(value));
    for (double share : sums.shares()) values.push_back(static_cast<float>(share));
  }
  return values;
}

/// Returns points within the reach of the ends, in rings around them.
std::vector<Vec2> points_round_ends(const Drawing& drawing) {
  std::vector<Vec2> points;
  for (const FreeEnd& end : ends_of(drawing)) {
    for (double share : {0.03, 0.2, 0.6, 0.95, 1.1}) {
      for (int i = 0; i < 7; ++i) {
        const double angle = 0.3 + 0.9 * i;
        const Vec2 p = end.position + share * end.reach * Vec2{std::cos(angle), std::sin(angle)};
        if (p.x > 1 && p.x < 511 && p.y > 1 && p.y < 511 &&
            distance_to_lines(drawing.lines, p) > 0.02) {
          points.push_back(p);
        }
      }
    }
  }
  return points;
}

std::vector<Line> narrowly_blended_lines(std::uint32_t seed) {
  return with_blends(random_lines(seed, 80, 0.1, 0.1), seed, 20, 4);
}

TEST(FreeEnds, beside_a_straight_curve_the_colour_turns_with_the_angle_alone) {
  const Drawing drawing = draw({two_sided({{56, 256}, {456, 256}})});
  const std::vector<FreeEnd> ends = ends_of(drawing);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_DOUBLE_EQ(ends[0].reach, 400);
  Context context;
  for (double r : {0.4, 2.0, 6.0}) {
    for (int i = 1; i < 12; ++i) {
      // The end on the right; white is above, which is the left on the screen.
      const double off = std::numbers::pi * (i - 6) / 6.5;
      const Vec2 p{456 + r * std::cos(off), 256 + r * std::sin(off)};
      const double s = std::sin(off), c = std::cos(off), turned = std::fabs(off);
      const double own = off == 0 ? 0 : (turned - std::fabs(s) * c) / (2 * s * s);
      const double side = s < 0 ? 1 : 0, mixed = 0.5 - 0.5 * std::sin(off / 2);
      const double expected = (own * side + 0.8 * mixed) / (own + 0.8);
      EXPECT_NEAR(soft_at(context, drawing, {p}).value[0], expected, 6e-3) << r << ' ' << off;
    }
  }
}

TEST(FreeEnds, beyond_the_reach_the_bits_are_the_papers) {
  const Drawing drawing = draw(random_lines(31, 60, 0.1, 0.1));
  const std::vector<FreeEnd> ends = ends_of(drawing);
  EXPECT_GT(ends.size(), 60u);
  std::vector<Vec2> points;
  for (Vec2 p : random_points(drawing, 31, 1000, 0.1)) {
    const bool is_reached = std::ranges::any_of(
        ends, [&](const FreeEnd& e) { return length(p - e.position) < e.reach * 1.0001; });
    if (!is_reached) points.push_back(p);
  }
  EXPECT_GT(points.size(), 100u);
  Context context;
  EXPECT_EQ(soft_at(context, drawing, points).value, gather_at(context, drawing, points).value);
}

TEST(FreeEnds, closed_curves_junctions_and_sides_without_colour_have_none) {
  const Line wall = two_sided({{256, 16}, {256, 496}});
  EXPECT_TRUE(ends_of(draw({two_sided({{100, 100}, {300, 100}, {200, 300}, {100, 100}})})).empty());
  EXPECT_EQ(ends_of(draw({wall, two_sided({{64, 256}, {256, 256}})})).size(), 3u);
  Line open = two_sided({{64, 256}, {200, 256}}), barrier = open, image = open, same = open;
  open.left_kind = ShaderKind::open;
  barrier.right_kind = ShaderKind::barrier;
  image.left_kind = ShaderKind::image_domain;
  same.right = same.left;
  for (const Line& line : {open, barrier, image, same}) EXPECT_TRUE(ends_of(draw({line})).empty());
}

TEST(FreeEnds, the_reach_is_the_distance_of_the_nearest_other_curve) {
  for (std::uint32_t seed = 40; seed < 44; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 90, 0.1, 0));
    for (const FreeEnd& end : ends_of(drawing)) {
      double expected = 1e300;
      for (const Line& line : drawing.lines) {
        const bool is_own = line.points[0] == end.position || line.points[1] == end.position;
        expected = std::min(expected, is_own ? length(line.points[1] - line.points[0])
                                             : distance_to_lines({line}, end.position));
      }
      EXPECT_NEAR(end.reach, expected, 1e-9);
    }
  }
}

TEST(FreeEnds, a_finely_cut_curve_hides_no_other_and_stands_in_its_own_way_where_it_turns_back) {
  Line fine = two_sided({});
  for (int i = 0; i <= 200; ++i) fine.points.push_back({100 + i / 2.0, 256});
  fine.left.assign(fine.points.size(), kWhite);
  fine.right.assign(fine.points.size(), kBlack);
  const std::vector<FreeEnd> fine_ends =
      ends_of(draw({fine, two_sided({{20, 16}, {20, 496}}), two_sided({{160, 300}, {180, 300}})}));
  const auto at = [](const std::vector<FreeEnd>& ends, Vec2 p) {
    const auto end = std::ranges::find_if(ends, [&](const FreeEnd& e) { return e.position == p; });
    return end == ends.end() ? -1.0 : end->reach;
  };
  EXPECT_NEAR(at(fine_ends, {100, 256}), std::hypot(60.0, 44.0), 1e-9);
  EXPECT_NEAR(at(fine_ends, {200, 256}), std::hypot(20.0, 44.0), 1e-9);
  const std::vector<FreeEnd> hook =
      ends_of(draw({two_sided({{100, 100}, {300, 100}, {300, 130}, {100, 130}})}));
  EXPECT_NEAR(at(hook, {100, 100}), 30, 1e-9);
}

/// Returns arcs of a circle, and one that turns the other way in its second half.
std::vector<Line> bent_curves() {
  Line arc = two_sided({}), wave = two_sided({});
  for (int i = 0; i <= 200; ++i) {
    const double turn = 1.9 * i / 200;
    arc.points.push_back({60 + 150 * std::sin(turn), 330 - 150 * std::cos(turn)});
    wave.points.push_back({20.0 + 2 * i, 440 + 40 * std::sin(std::numbers::pi * i / 100)});
  }
  for (Line* line : {&arc, &wave}) {
    line->left.assign(line->points.size(), kWhite);
    line->right.assign(line->points.size(), kBlack);
  }
  return {arc, wave};
}

TEST(FreeEnds, beside_a_bent_curve_no_colour_steps_across_the_line_of_its_end) {
  const Drawing drawing = draw(bent_curves());
  const std::vector<FreeEnd> ends = ends_of(drawing);
  ASSERT_EQ(ends.size(), 4u);
  Context context;
  for (const FreeEnd& end : ends) {
    EXPECT_NE(end.bend, 0);
    for (double share = 0.05; share < 1; share += 0.05) {
      std::vector<Vec2> round;
      constexpr int kSteps = 4000;
      for (int i = 0; i < kSteps; ++i) {
        const double angle = 2 * std::numbers::pi * i / kSteps;
        round.push_back(end.position + share * end.reach * Vec2{std::cos(angle), std::sin(angle)});
      }
      std::erase_if(round, [](Vec2 p) { return p.x < 1 || p.x > 511 || p.y < 1 || p.y > 511; });
      const Gathered gathered = soft_at(context, drawing, round);
      const std::size_t channels = gathered.value.size() / round.size();
      const auto step = [&](std::size_t i) {
        const bool is_far = length(round[i] - round[i - 1]) > 0.01 * share * end.reach ||
                            distance_to_lines(drawing.lines, round[i]) < 0.02 * share * end.reach;
        return is_far
                   ? 0.0f
                   : std::fabs(gathered.value[i * channels] - gathered.value[(i - 1) * channels]);
      };
      for (std::size_t i = 3; i < round.size(); ++i) {
        EXPECT_LE(step(i - 1), std::max(step(i - 2), step(i)) + 0.5f / 255)
            << end.position.x << ", " << share << " of " << end.reach << ", " << i;
      }
    }
  }
}

TEST(FreeEnds, the_packets_agree_with_the_reference_also_blurred_weighted_and_with_shaders) {
  for (std::uint32_t seed = 50; seed < 53; ++seed) {
    for (bool blends : {false, true}) {
      const Drawing drawing =
          draw(blends ? narrowly_blended_lines(seed) : random_lines(seed, 80, 0.1, 0.1));
      const std::vector<Vec2> points = points_round_ends(drawing);
      EXPECT_GT(points.size(), 300u);
      Context context;
      const Difference d =
          difference(soft_at(context, drawing, points).value, soft_reference_at(drawing, points));
      EXPECT_LE(d.rms, 0.01);
      EXPECT_LE(d.largest, 0.2);
    }
  }
}

TEST(FreeEnds, rays_get_the_same_term) {
  const Drawing drawing = draw(narrowly_blended_lines(61));
  const std::vector<Vec2> points = points_round_ends(drawing);
  Context context;
  const Gathered exact = soft_at(context, drawing, points);
  const Gathered rays =
      soft_at(context, drawing, points, {.method = Method::rays, .rays_per_node = 4096});
  EXPECT_LE(difference(rays.value, exact.value).rms, 1.5);
}

/// One point lies on an end, where there is no term.
TEST(FreeEnds, packets_and_points_get_the_same_term) {
  const Drawing drawing = draw(narrowly_blended_lines(64));
  Context context;
  const Result<FreeEnds> ends = FreeEnds::create(context, drawing.mesh, drawing.attributes, {}, 1);
  ASSERT_TRUE(ends.ok());
  SceneView scene{};
  scene.base_channels = 3;
  scene.ends = ends->view();
  std::mt19937 random(64);
  std::uniform_real_distribution<float> share(-0.3f, 0.3f);
  int reached = 0;
  for (std::uint32_t e = 0; e < scene.ends.term_count; ++e) {
    const EndTerm& end = scene.ends.term[e];
    const float reach = 1 / std::sqrt(end.inverse_reach_squared);
    PacketInput input{};
    PacketResult result{};
    for (int i = 0; i < kPacketLanes; ++i) {
      input.x[i] = i == 0 ? end.x : end.x + reach * share(random);
      input.y[i] = i == 0 ? end.y : end.y + reach * share(random);
      result.weight[i] = 0.01f * static_cast<float>(1 + i % 4);
      for (int c = 0; c < 3; ++c) result.value[c][i] = 0.1f * static_cast<float>(c + i % 5);
    }
    const PacketResult before = result;
    EndTerms<4>(scene, input, result).add();
    for (int i = 0; i < kPacketLanes; ++i) {
      std::vector<float> value{before.value[0][i], before.value[1][i], before.value[2][i]};
      const float weight = ends->add({input.x[i], input.y[i]}, before.weight[i], value);
      reached += weight > before.weight[i];
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(result.value[c][i], value[c], 1e-3) << e << ' ' << i;
    }
  }
  EXPECT_GT(reached, 100);
}

TEST(FreeEnds, every_width_and_thread_count_gives_the_same_bits) {
  const Drawing drawing = draw(narrowly_blended_lines(62));
  const std::vector<Vec2> points = points_round_ends(drawing);
  Context plain;
  plain.simd = SimdLevel::sse2;
  const std::vector<float> expected = soft_at(plain, drawing, points).value;
  for (int threads : {1, 3}) {
    for (SimdLevel level : {SimdLevel::sse2, SimdLevel::avx2, SimdLevel::avx512}) {
      if (level > detected_simd_level()) continue;
      ThreadPool pool(threads);
      Context context;
      context.executor = &pool;
      context.simd = level;
      EXPECT_EQ(soft_at(context, drawing, points).value, expected);
    }
  }
}

TEST(FreeEnds, a_value_does_not_depend_on_the_points_beside_it) {
  const Drawing drawing = draw(narrowly_blended_lines(63));
  const std::vector<Vec2> points = points_round_ends(drawing);
  Context context;
  const std::vector<float> together = soft_at(context, drawing, points).value;
  const std::size_t channels = together.size() / points.size();
  const Result<Gatherer> gatherer =
      Gatherer::create(context, drawing.mesh, drawing.attributes, Ends::soft);
  ASSERT_TRUE(gatherer.ok());
  std::vector<float> alone(channels);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); i += 7) {
    ASSERT_TRUE(gatherer->gather(context, std::span(&points[i], 1), {}, alone).ok());
    for (std::size_t c = 0; c < channels; ++c) {
      worst = std::max(worst, std::fabs(double{alone[c]} - together[channels * i + c]));
    }
  }
  // The skipped windows and the order of sums depend on the packet; ends do not.
  EXPECT_LE(worst, 1e-4);
}

TEST(FreeEnds, a_hundred_thousand_are_charged_and_found_in_a_second_or_so) {
  std::vector<Line> lines;
  for (int i = 0; i < 50'000; ++i) {
    const Vec2 at{2.0 * (i % 250) + 4, 2.0 * (i / 250) + 4};
    lines.push_back(two_sided({at, at + Vec2{1, 0.5}}));
  }
  const Drawing drawing = draw(std::move(lines));
  EXPECT_EQ(ends_of(drawing).size(), 100'000u);
  Context poor;
  ASSERT_TRUE(poor.budget.charge(poor.budget.limit() - (1 << 20), "the rest").ok());
  EXPECT_EQ(FreeEnds::create(poor, drawing.mesh, drawing.attributes, {}, 1).status().code,
            StatusCode::limit);
}

TEST(FreeEnds, dust_below_a_lattice_step_reaches_nowhere) {
  std::vector<Line> lines;
  for (int i = 0; i < 200; ++i) {
    const Vec2 at{100 + i / 16.0, 100};
    lines.push_back(two_sided({at, at + Vec2{0, 1.0 / 16}}));
  }
  const Drawing drawing = draw(std::move(lines));
  Context context;
  const std::vector<Vec2> points = random_points(drawing, 5, 300, 0.01);
  for (float value : soft_at(context, drawing, points).value) EXPECT_TRUE(value >= 0 && value <= 1);
}

}  // namespace
}  // namespace sfumato::gather::test
