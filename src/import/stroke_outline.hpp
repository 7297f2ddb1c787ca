#pragma once

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "formats/svg/plain_svg.hpp"
#include "import/boundary.hpp"
#include "import/point_meter.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg_import {

/// The outline of stroked subpaths (SVG 2, 13.5: caps, joins, miter limit, dashes): contours that
/// fill the stroke by the rule "nonzero". All have the same orientation, so that nothing is lost
/// where they overlap, or where a stroke is wider than its bends. Offsets of curves and the
/// envelopes of their normals keep within the tolerance. A subpath that ends at its start is
/// closed.
///
/// tolerance   in the subpaths' units; raised above the rounding errors of their coordinates
/// memory      charged for the contours as long as they exist; null: the charge is released on
///             return
/// Errors      limit (memory, too many dashes or points), cancelled.
Result<Contours> stroke_outline(Context& context, const Contours& subpaths,
                                const svg::StrokeStyle& style, double tolerance,
                                TableMemory* memory = nullptr);

/// A subpath so short that only its caps are visible: a disk, or a square along `direction`, a unit
/// vector.
std::vector<Vec2> dot(Vec2 point, Vec2 direction, const svg::StrokeStyle& style);

/// The direction of the curve at t, a unit vector; if the derivative is 0, the direction to the
/// next distinct point.
Vec2 tangent_at(const curves::Cubic& cubic, double t);

/// The parts of the subpaths that dashes leave; a dash of length 0 is a dot.
/// Errors: limit, cancelled.
Result<Contours> dashed(PointMeter& meter, const Contours& subpaths, const svg::StrokeStyle& style,
                        TableMemory& memory);

}  // namespace sfumato::svg_import
