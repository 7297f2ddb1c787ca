#include "import/chord_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace sfumato::svg_import {
namespace {

constexpr std::size_t kPairs = 200'000'000;  ///< looked at: about a second
constexpr std::size_t kCrossings = 1'000'000;
constexpr double kParallel = 1e-9;  ///< sine of the angle between chords that are parallel
/// Of a chord: so far beyond its ends it still meets others, which then end on it.
constexpr double kSlack = 1e-9;

double lowest_x(const Chord& chord) {
  return std::min(chord.from.x, chord.to.x);
}
double highest_x(const Chord& chord) {
  return std::max(chord.from.x, chord.to.x);
}

bool boxes_overlap_in_y(const Chord& a, const Chord& b) {
  return std::min(a.from.y, a.to.y) <= std::max(b.from.y, b.to.y) &&
         std::min(b.from.y, b.to.y) <= std::max(a.from.y, a.to.y);
}

bool is_within(double fraction) {
  return fraction >= -kSlack && fraction <= 1 + kSlack;
}

bool share_end(const Chord& a, const Chord& b) {
  return a.contour == b.contour && (a.to == b.from || b.to == a.from);
}

std::optional<Crossing> cross_chords(const Chord& a, const Chord& b) {
  const Vec2 along_a = a.to - a.from, along_b = b.to - b.from, between = b.from - a.from;
  const double denominator = cross(along_a, along_b);
  if (std::abs(denominator) <= kParallel * length(along_a) * length(along_b)) return std::nullopt;
  const double at_a = cross(between, along_b) / denominator;
  const double at_b = cross(between, along_a) / denominator;
  if (!is_within(at_a) || !is_within(at_b)) return std::nullopt;
  return Crossing{0, 0, std::clamp(at_a, 0.0, 1.0), std::clamp(at_b, 0.0, 1.0)};
}

}  // namespace

Result<std::vector<Crossing>> find_crossings(const Context& context,
                                             const std::vector<Chord>& chords) {
  std::vector<std::uint32_t> order(chords.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const double x_a = lowest_x(chords[a]), x_b = lowest_x(chords[b]);
    return x_a != x_b ? x_a < x_b : a < b;
  });
  std::vector<Crossing> crossings;
  std::vector<std::uint32_t> active;
  std::size_t pairs = 0;
  for (const std::uint32_t i : order) {
    if (context.cancelled()) return context.stop_status();
    const double x = lowest_x(chords[i]);
    std::erase_if(active, [&](std::uint32_t k) { return highest_x(chords[k]) < x; });
    pairs += active.size();
    if (pairs > kPairs || crossings.size() > kCrossings) {
      return make_error(StatusCode::limit, "the shape crosses itself too often");
    }
    for (const std::uint32_t k : active) {
      if (!boxes_overlap_in_y(chords[i], chords[k]) || share_end(chords[i], chords[k])) continue;
      auto crossing = cross_chords(chords[i], chords[k]);
      if (!crossing) continue;
      crossing->first = i;
      crossing->second = k;
      crossings.push_back(*crossing);
    }
    active.push_back(i);
  }
  return crossings;
}

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

}  // namespace sfumato::svg_import
