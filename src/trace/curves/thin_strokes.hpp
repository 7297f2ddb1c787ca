#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Returns the share of the length of curves along edges that are sides of thin strokes, for
/// example of letters: a few pixels across the curve, the picture has the colour of the other side
/// again. Errors: cancelled.
Result<double> stroke_share(const Context& context, std::span<const Plane> channels,
                            std::span<const TracedCurve> curves);

}  // namespace sfumato::tracing
