#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"
#include "support/twin_source.hpp"

// point_walk.glsl, compiled as C++.
namespace sfumato::gather::test {
namespace {

using sfumato::test::TwinSource;

template <int kStack = 16>
std::vector<float> walked(const Drawing& drawing, const std::vector<Vec2>& points) {
  TwinSource<kStack> twin;
  Context context;
  context.point_source = &twin;
  const std::vector<float> value = gather_at(context, drawing, points).value;
  EXPECT_EQ(twin.asked(), points.size());
  EXPECT_EQ(context.budget.used(), 0u);
  return value;
}

/// Returns a line along the lower border, and needles on it that hide the gaps between them.
std::vector<Line> comb(int needles) {
  std::vector<Line> lines{plain_line({{16, 16}, {496, 16}}, {1, 0, 0})};
  for (int i = 0; i < needles; ++i) {
    const double x = 20 + 470.0 * i / needles;
    const auto share = static_cast<float>(i) / static_cast<float>(needles);
    lines.push_back(plain_line({{x, 20}, {x + 0.5, 400.0 + i % 7}}, {share, 1 - share, 0.5f}));
  }
  return lines;
}

TEST(PointWalk, gives_the_reference_on_random_scenes) {
  for (std::uint32_t seed = 10; seed < 30; ++seed) {
    const int count = 10 + static_cast<int>(seed % 5) * 60;
    const Drawing drawing = draw(random_lines(seed, count, 0.15, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 1000, 0.05);
    const Difference d = difference(walked(drawing, points), reference_at(drawing, points));
    EXPECT_LE(d.rms, 5e-4) << seed;
    EXPECT_LE(d.largest, 0.02) << seed;
  }
}

TEST(PointWalk, gives_what_the_packets_give) {
  for (std::uint32_t seed = 30; seed < 40; ++seed) {
    const Drawing drawing = draw(random_lines(seed, 200, 0.1, 0.1));
    const std::vector<Vec2> points = random_points(drawing, seed, 1000, 0.05);
    Context context;
    const Gathered packets = gather_at(context, drawing, points);
    TwinSource<> twin;
    context.point_source = &twin;
    const Gathered walk = gather_at(context, drawing, points);
    const Difference d = difference(walk.value, packets.value);
    EXPECT_LE(d.rms, 2e-3) << seed;  // the packets leave more out
    EXPECT_LE(d.largest, 0.02) << seed;
    EXPECT_EQ(walk.hit, packets.hit);
  }
}

TEST(PointWalk, has_blur_and_shares_of_shaders) {
  for (std::uint32_t seed = 200; seed < 208; ++seed) {
    const Drawing drawing = draw(with_blends(random_lines(seed, 80, 0.1, 0.1), seed, 40, 5));
    const std::vector<Vec2> points = random_points(drawing, seed, 500, 0.5);
    Context context;
    const std::vector<float> packets = gather_at(context, drawing, points).value;
    const Difference d = difference(walked(drawing, points), packets);
    EXPECT_LE(d.rms, 2e-3) << seed;
    EXPECT_LE(d.largest, 0.05) << seed;
  }
}

TEST(PointWalk, forgets_windows_and_finds_them_again) {
  const Drawing drawings[] = {draw(specks(7, 300)), draw(comb(400)),
                              draw(random_lines(5, 300, 0.1, 0.1))};
  for (const Drawing& drawing : drawings) {
    const std::vector<Vec2> points = random_points(drawing, 3, 200, 0.05);
    const std::vector<float> roomy = walked<1024>(drawing, points);
    EXPECT_LE(difference(walked<16>(drawing, points), roomy).largest, 0.02);
    EXPECT_LE(difference(walked<8>(drawing, points), roomy).largest, 0.02);
    EXPECT_LE(difference(walked<4>(drawing, points), roomy).largest, 0.02);
    EXPECT_LE(difference(walked<1>(drawing, points), roomy).largest, 0.02);
  }
}

TEST(PointWalk, leaves_a_walk_without_end_to_the_packets) {
  const Drawing drawing = draw(specks(9, 200));
  const std::vector<Vec2> points = random_points(drawing, 9, 300, 0.05);
  Context context;
  const Gathered packets = gather_at(context, drawing, points);
  TwinSource<> twin;
  twin.step_limit = 100;
  context.point_source = &twin;
  const Gathered walk = gather_at(context, drawing, points);
  EXPECT_EQ(walk.value, packets.value);
  EXPECT_EQ(walk.hit, packets.hit);
  EXPECT_EQ(twin.most_steps(), 101);
}

/// A source that supports nothing, or not every scene.
class PoorSource : public TwinSource<> {
 public:
  PoorSource(StatusCode code, int answers) : code_(code), answers_(answers) {}

  Status sum(Context& context, const Scene& scene, std::span<const WalkPoint> point,
             std::span<float> sums) override {
    if (answers_-- <= 0) return make_error(code_, "a device that does nothing");
    Status status = TwinSource<>::sum(context, scene, point, sums);
    for (std::size_t i = 0; i < point.size(); i += 7) sums[i * sums_of_point(scene)] = NAN;
    return status;
  }

 private:
  StatusCode code_;
  int answers_;
};

TEST(PointWalk, the_packets_do_what_a_source_cannot) {
  const Drawing drawing = draw(with_blends(random_lines(4, 80, 0.1, 0.1), 4, 40, 5));
  const std::vector<Vec2> points = random_points(drawing, 4, 500, 0.5);
  ThreadPool pool(3);
  Context context;
  context.executor = &pool;
  const Gathered packets = gather_at(context, drawing, points);
  PoorSource none(StatusCode::unavailable, 0), some(StatusCode::unavailable, 1);
  context.point_source = &none;
  const Gathered without = gather_at(context, drawing, points);
  EXPECT_EQ(without.value, packets.value);
  EXPECT_EQ(without.hit, packets.hit);
  context.point_source = &some;
  EXPECT_LE(difference(gather_at(context, drawing, points).value, packets.value).largest, 0.05);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(PointWalk, errors_of_a_source_are_told) {
  const Drawing drawing = draw(random_lines(4, 80, 0.1, 0.1));
  const std::vector<Vec2> points = random_points(drawing, 4, 50, 0.5);
  Context context;
  PoorSource late(StatusCode::cancelled, 0);
  context.point_source = &late;
  const Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  ASSERT_TRUE(gatherer.ok());
  std::vector<float> out(3 * points.size());
  EXPECT_EQ(gatherer->gather(context, points, {}, out).code, StatusCode::cancelled);
}

}  // namespace
}  // namespace sfumato::gather::test
