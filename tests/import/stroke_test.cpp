// Outlines of strokes: their cost, and their content for wide strokes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "import/chords.hpp"
#include "import/stroke_outline.hpp"
#include "sfumato/base/box.hpp"
#include "support/flattened.hpp"
#include "support/poll_recorder.hpp"

namespace sfumato {
namespace {

using svg_import::Contours;

constexpr double kStrokeTolerance = 100.0 / 16384;

/// Returns a subpath of loops that end in cusps.
Contours curls(int count) {
  std::vector<Vec2> path{{50, 50}};
  for (int i = 0; i < count; ++i) path.insert(path.end(), {{59, 50}, {41, 59}, {50, 50}});
  return {path};
}

TEST(StrokeOutline, charges_its_points_for_as_long_as_they_live) {
  Context context;
  {
    TableMemory memory("a test");
    const auto outline =
        svg_import::stroke_outline(context, curls(1000), {.width = 2}, kStrokeTolerance, &memory);
    ASSERT_TRUE(outline);
    std::size_t points = 0;
    for (const auto& contour : *outline) points += contour.size();
    EXPECT_GE(context.budget.used(), points * sizeof(Vec2));
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(StrokeOutline, ends_at_the_memory_limit) {
  for (const std::vector<double>& dashes : {std::vector<double>{}, {1, 1}}) {
    Context context{.budget = Budget(1'000'000)};
    const svg::StrokeStyle style{.width = 2, .dashes = dashes};
    const auto outline = svg_import::stroke_outline(context, curls(1000), style, kStrokeTolerance);
    ASSERT_FALSE(outline);
    EXPECT_EQ(outline.status().code, StatusCode::limit);
  }
}

TEST(StrokeOutline, of_one_long_subpath_looks_at_the_flag) {
  for (const std::vector<double>& dashes : {std::vector<double>{}, {1, 1}}) {
    Context context;
    test::PollRecorder polls;
    context.poll_watch = &polls;
    const svg::StrokeStyle style{.width = 2, .dashes = dashes};
    ASSERT_TRUE(svg_import::stroke_outline(context, curls(1000), style, kStrokeTolerance));
    EXPECT_GE(polls.polls(), 1000u);
  }
}

TEST(StrokeOutline, far_from_the_origin_is_as_exact_as_its_coordinates) {
  Context context;
  std::vector<Vec2> path = curls(1)[0];
  for (Vec2& p : path) p = p + Vec2{1e7, 1e7};
  const auto outline = svg_import::stroke_outline(context, {path}, {.width = 2}, 1e-12);
  ASSERT_TRUE(outline);
  EXPECT_LT(outline->at(0).size(), 3000u);
}

std::vector<svg_import::Chord> chords_of(const Contours& contours) {
  std::vector<svg_import::Chord> chords;
  for (const auto& contour : contours) {
    EXPECT_EQ(contour.front(), contour.back());
    const std::vector<Vec2> polygon = test::flattened(contour, kStrokeTolerance / 8);
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      chords.push_back({polygon[i - 1], polygon[i]});
    }
  }
  return chords;
}

double distance(const std::vector<Vec2>& polygon, Vec2 p) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Vec2 along = polygon[i] - polygon[i - 1], to = p - polygon[i - 1];
    const double size = length_squared(along);
    const double t = size > 0 ? std::clamp(dot(to, along) / size, 0.0, 1.0) : 0;
    least = std::min(least, length(to - along * t));
  }
  return least;
}

/// Returns curves with bends of every sharpness: some nearly end in a cusp, some lie nearly on a
/// line.
std::vector<Vec2> random_cubic(std::mt19937& random) {
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Vec2> path;
  for (int i = 0; i < 4; ++i) path.push_back({30 + 40 * share(), 30 + 40 * share()});
  const double kind = share();
  if (kind < 0.2) {  // C' vanishes in the middle if both handles cross to each other's ends
    const Vec2 nearly{share() * share() * 0.5, share() * share() * 0.5};
    path[1] = path[0] + (path[3] - path[0]) + Vec2{0, 20};
    path[2] = path[0] + Vec2{0, 20} + nearly;
  } else if (kind < 0.3) {
    path[share() < 0.5 ? 1 : 2] = path[share() < 0.5 ? 0 : 3];
  } else if (kind < 0.4) {
    path[3] = path[0];
  }
  return path;
}

/// Returns whether a point lies inside, or nearly: the normals' envelope, which bounds the swept
/// area, is only found approximately within the tolerance.
bool is_inside(const std::vector<svg_import::Chord>& chords, Vec2 p, Vec2 across) {
  return std::ranges::any_of(std::array{0, -1, 1}, [&](int step) {
    return svg_import::winding_number(chords, p + 2 * step * kStrokeTolerance * across) != 0;
  });
}

/// Expects the stroke within half the width along each normal, and not farther than that from the
/// path.
void expect_what_normals_sweep(const std::vector<Vec2>& path, const svg::StrokeStyle& style,
                               const std::string& name) {
  Context context;
  const auto outline = svg_import::stroke_outline(context, {path}, style, kStrokeTolerance);
  ASSERT_TRUE(outline) << name;
  const std::vector<svg_import::Chord> chords = chords_of(*outline);
  const double clearly = style.width / 2 - 4 * kStrokeTolerance;
  const curves::Cubic cubic = curves::piece(path, 0);
  for (int i = 1; i < 100; ++i) {
    const double t = i / 100.0 + 1e-4;
    for (const double away : {-1.0, -0.8, -0.5, -0.2, 0.2, 0.5, 0.8, 1.0}) {
      const Vec2 along = svg_import::tangent_at(cubic, t);
      const Vec2 p = curves::point_at(cubic, t) + left_of(along) * (away * clearly);
      ASSERT_TRUE(is_inside(chords, p, along)) << name << " at " << t << ", " << away;
    }
  }
  const std::vector<Vec2> axis = test::flattened(path, kStrokeTolerance / 4);
  Box box;
  for (const Vec2 p : path) box.extend(p);
  box = box.grown_by(style.width);
  for (int i = 0; i < 40 * 40; ++i) {
    const Vec2 p{box.min.x + box.width() * (i % 40 + 0.4871) / 40,
                 box.min.y + box.height() * (i / 40 + 0.5129) / 40};
    const double away = distance(axis, p);
    const bool is_round =
        style.cap == svg::StrokeCap::round && style.join == svg::StrokeJoin::round;
    if (away > style.width / 2 + 4 * kStrokeTolerance) {
      ASSERT_EQ(svg_import::winding_number(chords, p), 0)
          << name << " far at " << p.x << ' ' << p.y;
    } else if (is_round && away < clearly) {
      ASSERT_NE(svg_import::winding_number(chords, p), 0) << name << " at " << p.x << ' ' << p.y;
    }
  }
}

TEST(StrokeOutline, wider_than_its_bends_holds_what_its_normals_sweep) {
  for (std::uint32_t seed = 0; seed < 180; ++seed) {
    std::mt19937 random(seed);
    const std::vector<Vec2> path = random_cubic(random);
    for (const double width : {1.0, 8.0, 30.0, 80.0}) {
      const std::string name = "seed " + std::to_string(seed) + ", width " + std::to_string(width);
      expect_what_normals_sweep(path, {.width = width, .join = svg::StrokeJoin::bevel}, name);
      expect_what_normals_sweep(
          path, {.width = width, .cap = svg::StrokeCap::round, .join = svg::StrokeJoin::round},
          name);
    }
  }
}

}  // namespace
}  // namespace sfumato
