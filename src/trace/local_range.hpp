#pragma once

#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/picture.hpp"
#include "trace/sparse.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Between which values each stop is kept.
struct ValueBounds {
  std::vector<FourFloats> low, high;
};

/// For each stop, in the order of curves and sides, the range of the picture's values near it, a
/// little widened: a stop of which few pixels tell would else take any value, which shows as a
/// spot. Errors: cancelled.
Result<ValueBounds> bounds_near(Context& context, const Picture& picture,
                                std::span<const TracedCurve> curves);

}  // namespace sfumato::tracing
