#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/edges.hpp"
#include "trace/plane.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Curves fitted to the edges of some channels, without colours.
/// tolerance   of the fit to an edge of usual strength, pixels, times √scale
/// present     curves near which none is to be found
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
};

/// Of the candidates those that promise most for their control points, within a budget, none of
/// which lies along another or along what is present.
/// memory   of the candidates
/// Errors   limit (memory), cancelled
Result<std::vector<TracedCurve>> choose_curves(Context& context,
                                               std::vector<TracedCurve> candidates, int width,
                                               int height, const CurveBudget& budget,
                                               std::span<const TracedCurve> present,
                                               TableMemory& memory);

}  // namespace sfumato::tracing
