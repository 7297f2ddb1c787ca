#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato::gather {

/// Computes w₁ and w₂ (docs/mathematics.md) in double precision, from D = atan2: the visible part
/// from q1 (right end) to q2 (left end), relative to the point, with k = 1. Both are 0 where
/// cross(q1, q2) <= 0.
struct ReferenceWeights {
  double right = 0;
  double left = 0;
};
ReferenceWeights reference_weights(Vec2 q1, Vec2 q2);

}  // namespace sfumato::gather
