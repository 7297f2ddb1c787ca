#include "curves/tips.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/segment.hpp"

namespace sfumato::curves {
namespace {

/// The most knots that are removed from one side of a tip, and the most that are searched on its
/// other side.
constexpr int kMostKnots = 8;

/// A share of the reach: the mesh rounds its vertices.
constexpr double kRounding = 1.0 / 16;

/// A share of the tip's width at a knot: a chord that passes the knot at less than this distance
/// does not meet the tip's other side.
constexpr double kRoom = 1.0 / 4;

/// A chord that leads away from the tip's other side may pass a knot at this many times the reach.
constexpr double kRoomAway = 4;

class TipClearer {
 public:
  TipClearer(const std::vector<Knot>& knots, double reach)
      : knots_(knots),
        reach_((1 + kRounding) * reach),
        last_(knots.size() - 1),
        is_closed_(knots.size() > 3 && knots.front().point == knots.back().point) {}

  void run() {
    if (is_closed_) clear(0);
    for (std::size_t i = 1; i < last_; ++i) clear(i);
  }

  /// Returns per knot 1 where it has to be removed. Empty: none.
  const std::vector<std::uint8_t>& removed() const { return removed_; }

 private:
  enum class Way { back, ahead };

  /// Returns the next remaining knot; none beyond an end.
  std::optional<std::size_t> next(std::size_t i, Way way) const {
    do {
      if (way == Way::ahead) {
        if (i == last_) return std::nullopt;
        i = is_closed_ && i + 1 == last_ ? 0 : i + 1;
      } else {
        if (i == 0 && !is_closed_) return std::nullopt;
        i = i == 0 ? last_ - 1 : i - 1;
      }
    } while (!removed_.empty() && removed_[i] != 0);
    return i;
  }

  void clear(std::size_t tip) {
    const std::optional<std::size_t> before = next(tip, Way::back), after = next(tip, Way::ahead);
    if (!before || !after) return;
    const Vec2 at = knots_[tip].point;
    if (!(dot(knots_[*before].point - at, knots_[*after].point - at) > 0)) return;
    for (int round = 0; round < kMostKnots; ++round) {
      // Both sides are checked before either changes: a reversed curve has the same knots.
      const std::optional<std::size_t> from_back = removable(tip, Way::back);
      const std::optional<std::size_t> from_ahead = removable(tip, Way::ahead);
      if (!from_back && !from_ahead) return;
      removed_.resize(knots_.size());
      for (const auto& knot : {from_back, from_ahead}) {
        if (knot) removed_[*knot] = 1;
      }
    }
  }

  /// Returns the knot beside the tip, if it has to be removed.
  std::optional<std::size_t> removable(std::size_t tip, Way way) const {
    const std::optional<std::size_t> beside = next(tip, way);
    if (!beside || *beside == 0) return std::nullopt;  // a closed curve begins and ends there
    const std::optional<std::size_t> beyond = next(*beside, way);
    if (!beyond || *beyond == tip) return std::nullopt;
    const bool is_removable = lies_on_other_side(*beside, tip, way) ||
                              (width_at(knots_[*beside].point, *beside, tip, way) <= reach_ &&
                               stays_between(tip, *beyond, way));
    return is_removable ? beside : std::nullopt;
  }

  /// Returns whether a knot exists only because the tip's other side has one in its place.
  bool lies_on_other_side(std::size_t knot, std::size_t tip, Way way) const {
    if (!knots_[knot].is_junction) return false;
    std::optional<std::size_t> at = tip;
    for (int i = 0; i < kMostKnots && at; ++i) {
      at = next(*at, way == Way::back ? Way::ahead : Way::back);
      if (at && !knots_[*at].is_junction && knots_[*at].point == knots_[knot].point) return true;
    }
    return false;
  }

  /// Returns the distance of a point beside a knot from the other side of the tip.
  double width_at(Vec2 p, std::size_t knot, std::size_t tip, Way way) const {
    const Way other = way == Way::back ? Way::ahead : Way::back;
    double squared = std::numeric_limits<double>::infinity();
    std::size_t from = tip;
    for (int i = 0; i < kMostKnots; ++i) {
      const std::optional<std::size_t> to = next(from, other);
      if (!to || *to == knot) break;
      const Vec2 there = nearest_on_segment(p, knots_[from].point, knots_[*to].point);
      squared = std::min(squared, length_squared(p - there));
      from = *to;
    }
    return std::sqrt(squared);
  }

  /// Returns whether all knots from the tip to another one are close enough to the chord between
  /// them, so that the chord does not touch the tip's other side.
  bool stays_between(std::size_t tip, std::size_t beyond, Way way) const {
    const auto step = [&](std::size_t i) {
      if (way == Way::ahead) return is_closed_ && i + 1 == last_ ? 0 : i + 1;
      return i == 0 ? last_ - 1 : i - 1;
    };
    int count = 0;
    for (std::size_t i = step(tip); i != beyond; i = step(i)) {
      if (knots_[i].is_junction) continue;
      const Vec2 knot = knots_[i].point;
      const Vec2 on_chord = nearest_on_segment(knot, knots_[tip].point, knots_[beyond].point);
      const double width = width_at(knot, i, tip, way);
      const bool leads_away = width_at(on_chord, i, tip, way) > width;
      const double room = leads_away ? kRoomAway * reach_ : kRoom * std::min(width, reach_);
      if (length(on_chord - knot) > room || ++count > kMostKnots) return false;
    }
    return true;
  }

  const std::vector<Knot>& knots_;
  double reach_;
  std::size_t last_;
  bool is_closed_;
  std::vector<std::uint8_t> removed_;
};

}  // namespace

bool clear_tips(std::vector<Knot>& knots, double reach) {
  if (!(reach > 0) || knots.size() < 4) return false;
  TipClearer clearer(knots, reach);
  clearer.run();
  const std::vector<std::uint8_t>& removed = clearer.removed();
  if (removed.empty()) return false;
  std::size_t count = 0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (removed[i] == 0) knots[count++] = knots[i];
  }
  knots.resize(count);
  return true;
}

}  // namespace sfumato::curves
