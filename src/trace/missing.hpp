#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/picture.hpp"
#include "trace/plane.hpp"
#include "trace/traced_curve.hpp"

namespace sfumato::tracing {

/// What curves miss of a picture at every pixel: its colours less those that they are rendered
/// with, times its opacity; where that is not 1 everywhere, as a fourth plane the same of opacity.
///
/// missing   made, or used again where it is of this picture; `memory` is charged for it
/// Errors    limit, cancelled
/// Cost      diffuse() and rasterize() of the curves, twice where there is opacity
Status find_missing(Context& context, const Picture& picture, std::span<const TracedCurve> curves,
                    TableMemory& memory, std::vector<Plane>& missing);

}  // namespace sfumato::tracing
