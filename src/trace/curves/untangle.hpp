#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::tracing {

/// Removes clashes. A closed curve that crosses itself loses the loop, or becomes one curve for
/// each loop. If two curves cross with colours that do not match and one of them is closed, a curve
/// is cut there, and its parts beside the other curve are dropped. Changed and new curves have no
/// stops.
///
/// width, height   of the picture, pixels
/// Returns         whether anything was changed
/// Errors          limit, cancelled
Result<bool> untangle(Context& context, int width, int height, std::vector<TracedCurve>& curves);

}  // namespace sfumato::tracing
