#pragma once

#include <cstdint>
#include <span>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/local_range.hpp"
#include "trace/plane.hpp"
#include "trace/stack_points.hpp"

namespace sfumato::tracing {

/// Between which values the colours of a layer's stops are kept.
///
/// color     the picture, in the drawing's interpolation space
/// mixed     per stop of the layer: which share of what the picture shows of it is mixed with other
///           items. A stop that is so by more than a tenth is kept within [0, 1] alone, since the
///           picture does not show its colour
/// low, high per stop of the layer; others become what the picture has near the stop, a little
///           widened, wherever an instance has it
/// Errors    limit (memory), cancelled
Status find_stop_ranges(Context& context, const std::vector<Curve>& curves,
                        std::span<const Affine> pixel_from_layer, const Channels& color,
                        std::span<const float> mixed, std::span<FourFloats> low,
                        std::span<FourFloats> high);

}  // namespace sfumato::tracing
