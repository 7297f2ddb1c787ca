#pragma once

#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/picture.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Gives both sides of curves the colours that a picture has beside them: medians across and along
/// the curve (Orzan et al. 2008), in as few stops as follow them to within `tolerance`, Euclidean
/// in sRGB code values from 0 to 1. A frame gets those of its inside alone. Errors: cancelled.
Status sample_sides(Context& context, const Picture& picture, double tolerance,
                    std::span<TracedCurve> curves);

}  // namespace sfumato::tracing
