#pragma once

#include "base/context.hpp"
#include "base/status.hpp"
#include "formats/plain_svg.hpp"
#include "import/boundary.hpp"

namespace sfumato::svg_import {

/// The outline of stroked subpaths (SVG 2, 13.5: caps, joins, miter limit, dashes): contours that
/// fill the stroke by the rule "nonzero", where they overlap too. Offsets of curves keep to the
/// tolerance. A subpath that ends where it began is closed.
/// Errors: limit (too many dashes), cancelled.
Result<Contours> stroke_outline(const Context& context, const Contours& subpaths,
                                const StrokeStyle& style, double tolerance);

/// The parts of the subpaths that dashes leave. Errors: limit, cancelled.
Result<Contours> dashed(const Context& context, const Contours& subpaths, const StrokeStyle& style);

}  // namespace sfumato::svg_import
