#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "formats/svg/read/plain_svg.hpp"
#include "import/boundary.hpp"
#include "import/point_meter.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// Returns the outline of stroked subpaths (SVG 2, 13.5: caps, joins, miter limit, dashes):
/// contours that fill the stroke by the rule "nonzero". All have the same orientation, so that
/// nothing is lost where they overlap, or where a stroke is wider than its bends. Offsets of curves
/// and the envelopes of their normals keep within the tolerance. A subpath that ends at its start
/// is closed, unless it is one of StrokeStyle::open_loops.
///
/// tolerance   in the subpaths' units; raised above the rounding errors of their coordinates
/// memory      charged for the contours as long as they exist; null: the charge is released on
///             return
/// Errors      limit (memory, too many dashes or points), cancelled.
Result<Contours> stroke_outline(Context& context, const Contours& subpaths,
                                const svg::StrokeStyle& style, double tolerance,
                                TableMemory* memory = nullptr);

/// Returns a subpath so short that only its caps are visible: a disk, or a square along
/// `direction`, a unit vector.
std::vector<Vec2> dot(Vec2 point, Vec2 direction, const svg::StrokeStyle& style);

/// Returns the direction of the curve at t, a unit vector; if the derivative is 0, the direction to
/// the next distinct point.
Vec2 tangent_at(const curves::Cubic& cubic, double t);

/// Parts of subpaths.
struct Dashes {
  Contours chains;
  std::vector<std::uint8_t> is_open;  ///< per chain: 0 where it is all of a closed subpath
};

/// Returns the dashes of the subpaths; a dash of length 0 is a dot. Errors: limit, cancelled.
Result<Dashes> dashed(PointMeter& meter, const Contours& subpaths, const svg::StrokeStyle& style,
                      TableMemory& memory);

}  // namespace sfumato::svg_import
