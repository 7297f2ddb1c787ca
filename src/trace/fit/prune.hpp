#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/fit/sparse.hpp"

namespace sfumato::tracing {

/// How much is left out at a time.
struct PruneLimits {
  double share = 0;  ///< of all stops
  double cost = 0;   ///< added squared error
};

/// The change of the squared error with a stop: (AᵀA)_jj, per stop in the order of curves, sides
/// and stops.
struct PruneWeights {
  std::span<const float> color;
  std::span<const float> opacity;  ///< empty: it does not count
};

/// Marks the inner stops that change least if left out, within limits, and no two neighbours.
/// Leaving out stop j changes the squared error by about |c_j - c|² · (AᵀA)_jj, where c is the
/// value between its neighbours.
///
/// Returns   per stop 1 where it is to go
std::vector<std::uint8_t> stops_to_prune(std::span<const TracedCurve> curves,
                                         const PruneWeights& weight, const PruneLimits& limits);

/// Returns the values of all stops, after the marked ones are removed, as sums of the remaining
/// ones: a row for each stop, with one entry, or with two entries if it was between two remaining
/// stops. Errors: limit (memory), cancelled.
Result<SparseMatrix> values_without(Context& context, std::span<const TracedCurve> curves,
                                    std::span<const std::uint8_t> goes);

/// Leaves out the marked stops.
void prune_stops(std::span<const std::uint8_t> goes, std::span<TracedCurve> curves);

}  // namespace sfumato::tracing
