#pragma once

#include "sfumato/base/vec2.hpp"
#include "support/drawing.hpp"
#include "trace/curves/traced_curve.hpp"

namespace sfumato::test {

/// Returns a traced curve along another, with one colour on each side.
inline tracing::TracedCurve traced(const Curve& curve, tracing::SideValue left = {0, 0, 0, 1},
                                   tracing::SideValue right = {1, 1, 1, 1}) {
  tracing::TracedCurve traced;
  traced.control_points = curve.control_points;
  const double end = static_cast<double>(curve.piece_count());
  traced.side[0] = {{0, end}, {left, left}};
  traced.side[1] = {{0, end}, {right, right}};
  return traced;
}

}  // namespace sfumato::test
