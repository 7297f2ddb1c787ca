#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/plane.hpp"

namespace sfumato::tracing {

/// Replaces each value by the least over all pixels of their value plus the squared distance to
/// them, exactly (Felzenszwalb and Huttenlocher 2012): of a plane of 0 at some pixels and kFar
/// elsewhere, the squared distance to the nearest of them, pixels.
inline constexpr float kFar = 1e10f;
Status transform_distance(Context& context, Plane& plane);

}  // namespace sfumato::tracing
