#pragma once

#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg_import {

/// Chains of cubic Béziers, 3 n + 1 control points each.
using Contours = std::vector<std::vector<Vec2>>;

/// The boundary of what contours fill: curves with the inside on their right (a loop runs clockwise
/// around it, as seen on the screen), which cross nothing and meet only in their ends. Contours
/// that are open are closed by a straight line; where contours overlap, what lies within the filled
/// region is left out, and so is what is thinner than the tolerance: slits between contours, parts
/// that reach out from them.
///
/// tolerance   how exactly crossings are looked for, in the contours' units
/// memory      of the boundary, for as long as it lives; null: it is given back
/// Errors      limit, cancelled.
Result<Contours> fill_boundary(Context& context, const Contours& contours, bool even_odd,
                               double tolerance, TableMemory* memory = nullptr);

}  // namespace sfumato::svg_import
