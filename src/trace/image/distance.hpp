#pragma once

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Replaces each value by the minimum over all pixels of their value plus the squared distance to
/// them, exactly (Felzenszwalb and Huttenlocher 2012). A plane of 0 at some pixels and kFar
/// elsewhere becomes the squared distance to the nearest of these pixels, in pixels.
inline constexpr float kFar = 1e10f;
Status transform_distance(Context& context, Plane& plane);

}  // namespace sfumato::tracing
