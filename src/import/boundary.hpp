#pragma once

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/import/combine.hpp"

namespace sfumato::svg_import {

/// Chains of cubic Béziers, 3 n + 1 control points each.
using Contours = RegionContours;

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

/// Returns whether the functions here failed because the contours cross too often or are too long.
bool is_too_intricate(const Status& status);

/// The rules by which contours fill an area.
struct FilledContours {
  const Contours& contours;
  bool even_odd = false;  ///< else nonzero
};

/// Returns the boundary of the combination of two regions: their union, intersection, difference or
/// symmetric difference. Errors: as above.
Result<Contours> combined_boundary(Context& context, RegionOperation operation,
                                   const FilledContours& first, const FilledContours& second,
                                   double tolerance, TableMemory* memory = nullptr);

}  // namespace sfumato::svg_import
