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
/// fill the stroke by the rule "nonzero". None goes round what it fills the wrong way, so that
/// nothing is lost where they overlap, nor where a stroke is wider than its bends. Offsets of
/// curves and the envelopes of their normals keep to the tolerance. A subpath that ends where it
/// began is closed.
///
/// tolerance   in the subpaths' units; held above what rounding does to their coordinates
/// memory      of the contours, for as long as they live; null: it is given back
/// Errors      limit (memory, too many dashes or points), cancelled.
Result<Contours> stroke_outline(Context& context, const Contours& subpaths,
                                const svg::StrokeStyle& style, double tolerance,
                                TableMemory* memory = nullptr);

/// A subpath so short that its caps are all that is seen of it: a disk, or a square that stands
/// along `direction`, a unit vector.
std::vector<Vec2> dot(Vec2 point, Vec2 direction, const svg::StrokeStyle& style);

/// The direction of walking at t, a unit vector; where the derivative is 0, that towards the next
/// other point.
Vec2 tangent_at(const curves::Cubic& cubic, double t);

/// The parts of the subpaths that dashes leave; a dash of no length is a dot.
/// Errors: limit, cancelled.
Result<Contours> dashed(PointMeter& meter, const Contours& subpaths, const svg::StrokeStyle& style,
                        TableMemory& memory);

}  // namespace sfumato::svg_import
