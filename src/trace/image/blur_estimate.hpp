#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Radii below this are as good as none, pixels.
inline constexpr double kSharpRadius = 0.8;

/// Estimates the blur radius of each curve by how much the gradient on it falls from one scale to a
/// coarser one (Elder and Zucker 1998); 0: sharp. Curves with a frame stay as they are.
/// channels   of the picture, or of its missing part, where the edges were found
/// Errors     limit (memory), cancelled
Status estimate_blur(Context& context, std::span<const Plane> channels,
                     std::span<TracedCurve> curves);

}  // namespace sfumato::tracing
