#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// Ways to combine two regions: the points in either, in both, in the first alone, or in exactly
/// one.
enum class RegionOperation : std::uint8_t { unite, intersect, subtract, exclude };

/// The contours of a region, filled by the nonzero rule: chains of cubic Béziers, 3 n + 1 control
/// points each. Open chains are closed by a straight line.
using RegionContours = std::vector<std::vector<Vec2>>;

/// Returns the boundary of the combination of two regions: closed curves with the inside on their
/// right, as seen on a screen, which do not cross and meet only at their ends. It is empty if
/// nothing is left. Slits and projections thinner than the tolerance are left out.
///
/// tolerance   accuracy of crossings, in the contours' units, above 0
/// Errors      bad_input (a chain that is not 3 n + 1 finite points, a coordinate beyond 10^7, a
///             tolerance that is not above 0), limit (memory; contours that cross too often),
///             cancelled.
/// Cost        O(n log n) in the chords of the contours, plus the pairs whose boxes overlap
Result<RegionContours> combine_regions(Context& context, RegionOperation operation,
                                       const RegionContours& first, const RegionContours& second,
                                       double tolerance);

}  // namespace sfumato
