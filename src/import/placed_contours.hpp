#pragma once

#include "base/table_memory.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "import/boundary.hpp"
#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// Errors: limit (memory), cancelled.
Result<Contours> copy_of(Context& context, const Contours& from, TableMemory& memory);

/// Returns whether all coordinates are finite and at most limits::kCoordinate.
bool are_in_range(const Contours& contours);

void map_points(const Affine& map, Contours& contours);

/// Returns the outline of a stroke in the artboard's frame. Errors: as stroke_outline().
Result<Contours> placed_stroke(Context& context, const Contours& chains,
                               const svg::StrokeStyle& style, const Affine& artboard_from_user,
                               double tolerance, TableMemory& memory);

}  // namespace sfumato::svg_import
