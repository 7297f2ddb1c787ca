#pragma once

#include <cstddef>
#include <span>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/picture.hpp"

namespace sfumato::tracing {

/// Gives both sides of curves the colours that a picture has beside them: medians across and along
/// the curve (Orzan et al. 2008), in as few stops as follow them to within `tolerance`, Euclidean
/// in sRGB code values from 0 to 1. A frame gets colours on its inside alone. If that would take
/// more than `most_stops` for all these curves, the tolerance grows until it takes fewer, or each
/// side has two. Errors: cancelled.
Status sample_sides(Context& context, const Picture& picture, double tolerance,
                    std::size_t most_stops, std::span<TracedCurve> curves);

}  // namespace sfumato::tracing
