#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "trace/curves/traced_curve.hpp"
#include "trace/image/picture.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::tracing {

/// Computes what curves miss of a picture at every pixel: the picture's colours minus the rendered
/// ones, times its opacity. If the opacity is not 1 everywhere, a fourth plane has the difference
/// of opacities.
///
/// missing   made, or used again where it is of this picture; `memory` is charged for it
/// Errors    limit, cancelled
/// Cost      diffuse() and rasterize() of the curves, twice where there is opacity
Status find_missing(Context& context, const Picture& picture, std::span<const TracedCurve> curves,
                    TableMemory& memory, std::vector<Plane>& missing);

}  // namespace sfumato::tracing
