#include "gather/scene/weak_visibility.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "gather/scenes.hpp"
#include "support/cancel_at.hpp"

/// The points that may see a curve.
namespace sfumato::gather::test {
namespace {

using sfumato::test::CancelAt;

/// Returns a number per segment: 1 on the first curve.
std::vector<std::uint8_t> first_curve(const Drawing& drawing) {
  std::vector<std::uint8_t> is_watched(drawing.flat.vertex.size(), 0);
  std::fill_n(is_watched.begin(), drawing.flat.curve_begin[1], std::uint8_t{1});
  return is_watched;
}

/// Returns lines, the first with a shader wherever it stops rays, the others without one. The
/// shader's share of a value shows exactly which points see the first line.
std::vector<Line> with_a_tell_tale(std::vector<Line> lines) {
  Line& first = lines.front();
  for (ShaderKind* kind : {&first.left_kind, &first.right_kind}) {
    if (*kind == ShaderKind::curve_domain) *kind = ShaderKind::image_domain;
  }
  first.left_kind = ShaderKind::image_domain;
  return lines;
}

struct Seen {
  int by_share = 0;  ///< points with a share of the first curve
  int marked = 0;
  int missed = 0;
};

Seen look(const Drawing& drawing, const std::vector<Vec2>& points) {
  Context context;
  const std::vector<std::uint8_t> is_watched = first_curve(drawing);
  Result<Gatherer> gatherer =
      Gatherer::create(context, drawing.mesh, drawing.attributes, Ends::paper, {is_watched});
  EXPECT_TRUE(gatherer.ok());
  const auto channels = static_cast<std::size_t>(gatherer->channel_count());
  std::vector<float> value(channels * points.size());
  std::vector<std::uint8_t> sees(points.size(), 0);
  EXPECT_TRUE(gatherer->gather(context, points, {}, value).ok());
  EXPECT_TRUE(gatherer->find_changes(context, *gatherer, points, sees).ok());
  Seen seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_share = value[channels * i + channels - 1] > 0;
    seen.by_share += has_share;
    seen.marked += sees[i];
    seen.missed += has_share && !sees[i];
  }
  return seen;
}

TEST(WeakVisibility, marks_all_that_see_the_curve_and_few_others) {
  Seen all;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const int lines = 5 + static_cast<int>(seed) * 4;
    const Drawing drawing =
        draw(with_a_tell_tale(random_lines(seed, lines, 0.05 * (seed % 6), 0.1 * (seed % 2))));
    const Seen seen = look(drawing, random_points(drawing, seed, 2000, 0.01));
    EXPECT_EQ(seen.missed, 0);
    all.by_share += seen.by_share;
    all.marked += seen.marked;
  }
  // All points of a triangle are marked together.
  EXPECT_GT(all.by_share, 10'000);
  EXPECT_LT(all.marked, 2 * all.by_share);
}

TEST(WeakVisibility, ends_at_walls) {
  const Line watched = plain_line({{100, 100}, {100, 400}}, {1, 0, 0});
  const Line wall = plain_line({{200, -5000}, {200, 5000}}, {0, 1, 0});
  const Drawing drawing = draw({watched, wall});
  Context context;
  Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes,
                                               Ends::paper, {first_curve(drawing)});
  const std::vector<Vec2> points{{150, 250}, {20, 30}, {190, 500}, {300, 250}, {210, 100}};
  std::vector<std::uint8_t> sees(points.size(), 0);
  ASSERT_TRUE(gatherer->find_changes(context, *gatherer, points, sees).ok());
  EXPECT_EQ(sees, (std::vector<std::uint8_t>{1, 1, 1, 0, 0}));
}

TEST(WeakVisibility, leaves_other_points_as_they_are) {
  const Drawing drawing = draw({plain_line({{100, 100}, {100, 400}}, {1, 0, 0})});
  Context context;
  Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes,
                                               Ends::paper, {first_curve(drawing)});
  const std::vector<Vec2> table{{150, 250}, {20, 30}, {300, 250}};
  const std::vector<std::uint32_t> chosen{1};
  std::vector<std::uint8_t> sees{7, 0, 9};
  ASSERT_TRUE(gatherer->find_changes(context, *gatherer, {table, chosen}, sees).ok());
  EXPECT_EQ(sees, (std::vector<std::uint8_t>{7, 1, 9}));
}

TEST(WeakVisibility, without_watched_segments_marks_none) {
  const Drawing drawing = draw(random_lines(3, 20, 0, 0));
  Context context;
  Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes);
  const std::vector<Vec2> points = random_points(drawing, 3, 100, 1);
  std::vector<std::uint8_t> sees(points.size(), 0);
  ASSERT_TRUE(gatherer->find_changes(context, *gatherer, points, sees).ok());
  EXPECT_EQ(std::ranges::count(sees, 1), 0);
}

TEST(WeakVisibility, ends_when_it_is_cancelled) {
  const Drawing drawing = draw(random_lines(5, 60, 0.5, 0));
  for (std::uint64_t poll = 1;; ++poll) {
    Context context;
    Result<Gatherer> gatherer = Gatherer::create(context, drawing.mesh, drawing.attributes,
                                                 Ends::paper, {first_curve(drawing)});
    const std::vector<Vec2> points = random_points(drawing, 3, 100, 1);
    std::vector<std::uint8_t> sees(points.size(), 0);
    CancelAt watch(poll, context.cancel);
    context.poll_watch = &watch;
    const Status status = gatherer->find_changes(context, *gatherer, points, sees);
    if (!context.cancelled()) {
      EXPECT_GT(poll, 2u);
      break;
    }
    EXPECT_TRUE(status.ok() || status.code == StatusCode::cancelled);
  }
}

}  // namespace
}  // namespace sfumato::gather::test
