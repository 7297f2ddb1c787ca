#pragma once

#include <span>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::tracing {

/// Returns the nearest of 256 evenly spaced values from 0 to 1.
float in_eight_bits(float value);

/// Curves as a document has them, with coordinates times `unit_per_pixel`, and radii times the mean
/// of its two.
std::vector<Curve> document_curves(std::span<const TracedCurve> curves, Vec2 unit_per_pixel,
                                   bool has_opacity);

/// Returns the drawing of a picture of this size in user units.
Document drawing_of(std::span<const TracedCurve> curves, Vec2 size, Vec2 unit_per_pixel,
                    bool has_opacity);

}  // namespace sfumato::tracing
