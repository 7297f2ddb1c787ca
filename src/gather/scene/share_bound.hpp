#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// A bound on the change that curves inserted into a layer may cause far from them.
///
/// Within the angle A that it subtends, at distances of at least d, a curve weighs at most k A /
/// d² and hides at most A / d², in units of the largest weight. At a point of weight W₀ the mean Z
/// therefore changes by at most (1 + k) Â / (W₀ - Â) of the range of values, with Â the sum of
/// min(π, length / d) / d² over runs of a few segments, each d away by its bounding circle, or from
/// far away over groups of them.
class ShareBound {
 public:
  using Polyline = std::span<const Vec2>;

  /// Makes a bound.
  ///
  /// polylines  of the curves, layer frame
  /// weight     the largest weight of the curves
  /// most       the tolerated change, as a share of the range of values; 0: none
  /// most_runs  at least 1: with few of them the bound is quicker to compute, and coarser. Each
  ///            curve has one run or more
  /// Errors     limit (memory), cancelled
  static Result<ShareBound> create(const Context& context, std::span<const Polyline> polylines,
                                   double weight, double most,
                                   std::size_t most_runs = std::numeric_limits<std::size_t>::max());

  /// Returns whether no more than that changes at p, of at least this weight in units of
  /// `weight_unit`, the largest weight of the layer.
  bool holds_at(Vec2 p, float weight, float weight_unit) const;

  /// Returns the share of the range that may change at p, where `weight` and `weight_unit` are as
  /// in holds_at(); infinity: any.
  double share_at(Vec2 p, float weight, float weight_unit) const;

 private:
  struct Run {
    Vec2 center;
    double radius;
    double length;
  };

  /// A group of consecutive runs of one curve, which is used from far away.
  struct Group {
    Run all;
    std::size_t first;  ///< index into runs_
    std::size_t count;
  };

  static Run run_of(Polyline polyline);
  Status add(const Context& context, Polyline polyline, std::size_t per_run);

  /// Returns Â of one run, at p.
  static double angle_over_distance_squared(const Run& run, Vec2 p);

  /// Returns Â of a group, from its runs where it is near.
  double angle_of_group(const Group& group, Vec2 p) const;

  std::vector<Run> runs_;
  std::vector<Group> groups_;
  Run whole_{};  ///< all runs
  double weight_ = 1;
  double most_ = 0;
  TableMemory memory_{"a drag"};
};

}  // namespace sfumato::gather
