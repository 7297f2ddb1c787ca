// Strokes and fills with nearly equal parts: pieces and handles of the size of rounding errors, and
// paths that return along themselves. Compared with the area within half the width of the path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/text/number_text.hpp"
#include "import/boundary.hpp"
#include "import/chords.hpp"
#include "import/stroke_outline.hpp"
#include "sfumato/base/box.hpp"
#include "support/flattened.hpp"

namespace sfumato {
namespace {

using svg_import::Chord;
using svg_import::Contours;

constexpr double kTolerance = 100.0 / 16384;

void line_to(std::vector<Vec2>& chain, Vec2 to) {
  const Vec2 from = chain.back();
  chain.insert(chain.end(), {lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to});
}

std::vector<Chord> chords_of(const Contours& contours, double tolerance) {
  std::vector<Chord> chords;
  for (std::uint32_t c = 0; c < contours.size(); ++c) {
    const std::vector<Vec2> polygon = test::flattened(contours[c], tolerance);
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      chords.push_back({polygon[i - 1], polygon[i], 0, 0, c});
    }
  }
  return chords;
}

double distance(const std::vector<Chord>& path, Vec2 p) {
  double least = std::numeric_limits<double>::max();
  for (const Chord& chord : path) {
    const Vec2 along = chord.to - chord.from;
    const double size = length_squared(along);
    const double t = size > 0 ? std::clamp(dot(p - chord.from, along) / size, 0.0, 1.0) : 0;
    least = std::min(least, length(p - chord.from - along * t));
  }
  return least;
}

std::string text_of(const std::vector<Vec2>& path) {
  std::string text = "M";
  for (const Vec2 p : path) text += number_text(p.x) + ' ' + number_text(p.y) + ' ';
  return text;
}

/// Expects that a round stroke of the path covers the area within half its width exactly once.
void expect_stroke(const std::vector<Vec2>& path, double width, const std::string& name) {
  Context context;
  const svg::StrokeStyle style{
      .width = width, .cap = svg::StrokeCap::round, .join = svg::StrokeJoin::round};
  const auto outline = svg_import::stroke_outline(context, {path}, style, kTolerance);
  ASSERT_TRUE(outline) << name;
  const auto boundary = svg_import::fill_boundary(context, *outline, false, kTolerance);
  ASSERT_TRUE(boundary) << name << boundary.status().message;
  const std::vector<Chord> edges = chords_of(*boundary, kTolerance);
  const std::vector<Chord> axis = chords_of({path}, kTolerance / 16);
  Box box;
  for (const Vec2 p : path) box.extend(p);
  box = box.grown_by(width);
  for (int i = 0; i < 40 * 40; ++i) {
    const Vec2 p{box.min.x + box.width() * (i % 40 + 0.4871) / 40,
                 box.min.y + box.height() * (i / 40 + 0.5129) / 40};
    const double away = distance(axis, p) - width / 2;
    if (std::abs(away) < 8 * kTolerance) continue;
    ASSERT_EQ(svg_import::winding_number(edges, p), away < 0 ? 1 : 0)
        << name << " at " << p.x << ", " << p.y << ", " << away << " outside of " << text_of(path);
  }
}

/// Returns paths of lines and of nearly straight curves, many of which differ only by rounding.
std::vector<Vec2> random_path(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto tiny = [&] {
    return (share() < 0.5 ? 0 : share() < 0.5 ? 1 : -1) * std::pow(10, -9 + 8 * share());
  };
  const auto step = [&] { return 10.0 * (std::floor(share() * 3) - 1) + tiny(); };
  std::vector<Vec2> path{{50, 50}};
  for (int count = 2 + static_cast<int>(share() * 5); count > 0; --count) {
    const Vec2 from = path.back();
    if (share() < 0.4) {
      line_to(path, from + Vec2{tiny(), tiny()});
    } else if (share() < 0.7) {
      line_to(path, from + Vec2{step(), step()});
    } else {
      const Vec2 along{step(), step()};
      const double first = share() < 0.3 ? 0 : share(), second = share() < 0.3 ? 1 : share();
      path.push_back(from + along * std::min(first, second));
      path.push_back(from + along * std::max(first, second) + Vec2{tiny(), tiny()} * 1e-3);
      path.push_back(from + along);
    }
  }
  if (share() < 0.4) line_to(path, path.front());
  return path;
}

TEST(DegenerateStrokes, hold_what_is_within_half_their_width) {
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    const std::vector<Vec2> path = random_path(seed);
    expect_stroke(path, seed % 3 == 0 ? 1 : 4, "seed " + std::to_string(seed));
  }
}

TEST(DegenerateStrokes, of_a_way_there_and_back_are_that_of_the_way) {
  for (const double apart : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    for (const double turn : {0.0, 0.3, 1.0, 2.5}) {
      const Vec2 along{20 * std::cos(turn), 20 * std::sin(turn)}, aside{0, apart};
      std::vector<Vec2> path{{50, 50}};
      line_to(path, path.front() + along);
      line_to(path, path.back() + aside);
      line_to(path, path.front());
      expect_stroke(path, 4, std::to_string(apart) + " at " + std::to_string(turn));
    }
  }
}

TEST(DegenerateStrokes, a_piece_of_roundings_size_makes_no_corner) {
  Context context;
  for (const double apart : {1e-4, 1e-6, 1e-9}) {
    std::vector<Vec2> path{{30, 30}};
    line_to(path, {40, 30});
    line_to(path, {40, 30 + apart});
    line_to(path, {30, 30});
    const auto outline = svg_import::stroke_outline(context, {path}, {.width = 4}, kTolerance);
    const auto boundary = svg_import::fill_boundary(context, *outline, false, kTolerance);
    ASSERT_EQ(boundary->size(), 1u) << apart;
    Box box;
    for (const Vec2 p : boundary->at(0)) box.extend(p);
    EXPECT_NEAR(box.min.x, 30, 1e-3);  // the path turns back here, so a miter would be too long
    EXPECT_NEAR(box.max.x, 40, 1e-3);
    EXPECT_NEAR(box.height(), 4, 1e-3);
  }
}

TEST(DegenerateFills, of_contours_that_hardly_differ_are_that_of_one) {
  Context context;
  for (const double apart : {0.0, 1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3}) {
    Contours squares;
    for (int i = 0; i < 5; ++i) {
      const double at = i * apart;
      std::vector<Vec2> square{{10 + at, 10}};
      for (const Vec2 to : {Vec2{20, 10 + at}, Vec2{20 - at, 20}, Vec2{10, 20 + at}}) {
        line_to(square, to);
      }
      line_to(square, square.front());
      if (i % 2 == 1) std::ranges::reverse(square);
      squares.push_back(square);
    }
    for (const bool even_odd : {false, true}) {
      const auto boundary = svg_import::fill_boundary(context, squares, even_odd, kTolerance);
      ASSERT_TRUE(boundary);
      const std::vector<Chord> edges = chords_of(*boundary, kTolerance);
      EXPECT_EQ(svg_import::winding_number(edges, {15.1, 14.9}), 1) << apart << even_odd;
      EXPECT_EQ(svg_import::winding_number(edges, {9, 14.9}), 0) << apart << even_odd;
    }
  }
}

}  // namespace
}  // namespace sfumato
