#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Options of improve_shapes().
struct ShapeOptions {
  double reach = 2;  ///< errors are measured this far on each side of a sharp curve, pixels
  double give = 1;   ///< divides the resistance of control points
};

/// Moves curves sideways onto the edges of the picture. A shift δ to the right of an edge with the
/// jump Δ from left to right adds -Δ δ to the picture along it, spread over its blur. The missing
/// values across the curve, projected on Δ, give δ.
///
/// missing   the picture minus the drawing of the curves: colours, and opacity if it counts
/// Errors    cancelled
Status improve_shapes(Context& context, std::span<const Plane> missing,
                      std::span<TracedCurve> curves, const ShapeOptions& options = {});

}  // namespace sfumato::tracing
