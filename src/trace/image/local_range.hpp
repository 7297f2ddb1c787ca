#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/fit/sparse.hpp"
#include "trace/image/picture.hpp"

namespace sfumato::tracing {

/// The values of a plane in a square.
struct Range {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  void extend(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Half the side of the square that gives the range near a stop, pixels.
inline constexpr double kNearPx = 8;
/// Stops may leave the range near them by this much.
inline constexpr float kWiderRange = 0.1f;

/// Returns the range up to `reach` pixels from the pixel of p, or of the picture's nearest pixel.
Range range_near(const Plane& plane, Vec2 p, int reach);

/// Between which values each stop is kept.
struct ValueBounds {
  std::vector<FourFloats> low, high;
};

/// Finds for each stop, in the order of curves and sides, the range of the picture's values near
/// it, a little widened. Without the range, a stop that few pixels determine would take any value,
/// which shows as a spot. Errors: cancelled.
Result<ValueBounds> bounds_near(Context& context, const Picture& picture,
                                std::span<const TracedCurve> curves);

}  // namespace sfumato::tracing
