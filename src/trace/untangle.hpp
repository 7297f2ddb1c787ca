#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// Closed curves that cross themselves lose the loop, or become one for each loop; curves that
/// cross another of which one is closed, with colours that do not fit, are cut there, and what is
/// left of them beside the other is dropped. Curves that were changed or are new have no stops.
///
/// width, height   of the picture, pixels
/// Returns         whether anything was changed
/// Errors          limit, cancelled
Result<bool> untangle(Context& context, int width, int height, std::vector<TracedCurve>& curves);

}  // namespace sfumato::tracing
