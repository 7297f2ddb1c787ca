#include "import/chords.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/try.hpp"

namespace sfumato::svg_import {
namespace {

constexpr int kMostChords = 64;  ///< of one Bézier piece
constexpr int kHalvings = 40;    ///< of an interval of parameters

}  // namespace

int winding_number(const std::vector<Chord>& chords, Vec2 point) {
  int number = 0;
  for (const Chord& chord : chords) {
    const bool from_above = chord.from.y <= point.y, to_above = chord.to.y <= point.y;
    if (from_above == to_above) continue;
    const double side = cross(chord.to - chord.from, point - chord.from);
    if (from_above && side > 0) ++number;
    if (to_above && side < 0) --number;
  }
  return number;
}

Status append_stretch(Context& context, const std::vector<Vec2>& chain, double begin, double end,
                      TableMemory& memory, std::vector<Vec2>& points) {
  const std::size_t count = (chain.size() - 1) / 3;
  for (double low = begin; low < end;) {
    const auto i = std::min(static_cast<std::size_t>(low), count - 1);
    const auto base = static_cast<double>(i);
    const double high = std::min(end, base + 1);
    const curves::Cubic part = curves::subcurve(curves::piece(chain, i), low - base, high - base);
    SFUMATO_TRY(memory.make_room(context, points, part.size()));
    if (points.empty()) points.push_back(part[0]);
    points.insert(points.end(), part.begin() + 1, part.end());
    low = high;
  }
  return ok_status();
}

int chord_count(const curves::Cubic& cubic, double tolerance) {
  const curves::ChordDeviation deviation = curves::chord_deviation(cubic);
  const double wanted = std::sqrt(std::max(deviation.across, deviation.along / 8) / tolerance);
  return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, double{kMostChords}));
}

double parameter_beside(const curves::Cubic& cubic, double low, double high, Vec2 point) {
  const Vec2 along = curves::point_at(cubic, high) - curves::point_at(cubic, low);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = std::midpoint(low, high);
    const bool is_behind = dot(along, curves::point_at(cubic, middle) - point) < 0;
    (is_behind ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

}  // namespace sfumato::svg_import
