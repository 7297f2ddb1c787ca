#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/edges.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Curves fitted to the edges of some channels, without colours.
/// tolerance   of the fit to an edge of usual strength, pixels, times √scale
/// present     no candidate may lie near these curves
/// memory      of the candidates
/// Errors      limit (memory), cancelled
Result<std::vector<TracedCurve>> find_candidates(Context& context, std::span<const Plane> channels,
                                                 const EdgeOptions& options, double tolerance,
                                                 std::span<const TracedCurve> present,
                                                 TableMemory& memory);

/// How much may be chosen.
struct CurveBudget {
  std::size_t points = 0;  ///< control points
  std::size_t curves = 0;
  /// The cost of a curve in addition to its control points: few long curves are easier to edit than
  /// many short ones.
  double curve_price = 12;
  int apart = 1;  ///< the least distance between curves, pixels
};

/// Returns the candidates that promise most for their control points, within a budget. None lies
/// along another one or along a present curve.
/// memory   of the candidates
/// Errors   limit (memory), cancelled
Result<std::vector<TracedCurve>> choose_curves(Context& context,
                                               std::vector<TracedCurve> candidates, int width,
                                               int height, const CurveBudget& budget,
                                               std::span<const TracedCurve> present,
                                               TableMemory& memory);

}  // namespace sfumato::tracing
