#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato::solve {

/// Returns the angle from a to b turned in the direction of positive cross product, in [0, 2π), to
/// 1e-7. Computed only by sums, products and square roots, so that every platform gives the same
/// bits. Zero vectors count as angle 0.
double turn_angle(Vec2 a, Vec2 b);

}  // namespace sfumato::solve
