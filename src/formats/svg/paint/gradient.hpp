#pragma once

#include "formats/svg/paint/paint_attributes.hpp"
#include "formats/svg/read/totals.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg {

/// The coordinate system of a gradient.
struct GradientFrame {
  bool in_box = true;  ///< fractions of the shape's bounding box, not user units
  Affine layer_from_gradient;
};

/// gradientUnits and gradientTransform for a shape. Errors: bad_input.
Result<GradientFrame> read_gradient_frame(Input& input, const PaintAttributes& attributes,
                                          const PaintedShape& shape);

/// Reads a linearGradient or radialGradient (SVG 1.1, chapter 13). A gradient of length 0, which
/// SVG paints in the last stop's colour, gets only that stop. Errors: bad_input, limit.
/// last   reused if it belongs to the same gradient, else replaced
Result<GradientFill> read_gradient(Input& input, Totals& totals, const PaintAttributes& attributes,
                                   const GradientFrame& frame, const Box& viewport,
                                   GradientStops& last);

}  // namespace sfumato::svg
