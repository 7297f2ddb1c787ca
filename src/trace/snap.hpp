#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Moves ends of open curves that almost touch another curve, or the curve itself, onto it: colours
/// would leak through the gap. Cuts off ends that stick out a little beyond a curve, and closes
/// curves that are nearly closed. Where an end lands whose sides differ, the side of the other
/// curve gets a step: two stops at one place. Curves of which little is left go.
///
/// Errors          limit (memory), cancelled
/// width, height   of the picture, pixels
/// leak            an end whose sides differ less, in every channel, leaks nothing that shows
Status snap_to_curves(const Context& context, int width, int height, float leak,
                      std::vector<TracedCurve>& curves);

}  // namespace sfumato::tracing
