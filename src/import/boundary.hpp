#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// Chains of cubic Béziers, 3 n + 1 control points each.
using Contours = std::vector<std::vector<Vec2>>;

/// The boundary of the region that contours fill: curves with the inside on their right (a loop
/// runs clockwise around it, as seen on the screen), which do not cross and meet only at their
/// ends. Open contours are closed by a straight line. Parts of overlapping contours inside the
/// filled region are left out, and so is everything thinner than the tolerance: slits between
/// contours and thin parts that project from them.
///
/// tolerance   the accuracy of crossings, in the contours' units
/// memory      charged for the boundary as long as it exists; null: the charge is released on
///             return
/// Errors      limit, cancelled.
Result<Contours> fill_boundary(Context& context, const Contours& contours, bool even_odd,
                               double tolerance, TableMemory* memory = nullptr);

}  // namespace sfumato::svg_import
