#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/plane.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Moves curves across to where the picture has their edges. A shift δ to the right of an edge
/// whose jump from left to right is Δ adds -Δ δ to the picture along it, spread over its blur; what
/// is missing across the curve, projected on Δ, gives δ. missing   the picture less the drawing of
/// the curves: colours, and opacity if it counts Errors    cancelled
Status improve_shapes(Context& context, std::span<const Plane> missing,
                      std::span<TracedCurve> curves);

}  // namespace sfumato::tracing
