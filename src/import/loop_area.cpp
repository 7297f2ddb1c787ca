#include "import/loop_area.hpp"

#include <cmath>
#include <cstddef>

#include "curves/bezier.hpp"
#include "import/chords.hpp"

namespace sfumato::svg_import {
namespace {

/// Tolerances: the area over the length of a loop, about a quarter of its width. A hole may be
/// thinner, because holes between crossing lines are many and show together.
constexpr double kThinPart = 1;
constexpr double kThinHole = 0.5;

/// Twice the area between a cubic, seen from its first point, and its chord: the integral of
/// cross(p, p').
double bulge(const curves::Cubic& cubic) {
  const Vec2 a = cubic[1] - cubic[0], b = cubic[2] - cubic[0], c = cubic[3] - cubic[0];
  return 0.3 * (cross(a, b) + cross(a, c) + 2 * cross(b, c));
}

}  // namespace

double signed_area(const std::vector<Vec2>& chain) {
  double twice = 0;
  for (std::size_t i = 0; 3 * i + 3 < chain.size(); ++i) {
    const curves::Cubic cubic = curves::piece(chain, i);
    twice += cross(cubic[0] - chain[0], cubic[3] - chain[0]) + bulge(cubic);
  }
  return twice / 2;
}

bool is_sliver(const std::vector<Vec2>& loop, double tolerance) {
  const Vec2 origin = loop.front();
  Vec2 before = origin;
  double area = 0, around = 0;
  for_each_chord_end(loop, tolerance, [&](Vec2 end) {
    area += cross(before - origin, end - origin) / 2;
    around += length(end - before);
    before = end;
  });
  return std::abs(area) <= (area < 0 ? kThinHole : kThinPart) * tolerance * around;
}

}  // namespace sfumato::svg_import
