#pragma once

#include <algorithm>

#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// Returns the point of the segment from a to b that is nearest to p. The segment may have no
/// length.
inline Vec2 nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = length_squared(along);
  return lerp(a, b, square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0);
}

}  // namespace sfumato
