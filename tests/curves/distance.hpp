#pragma once

#include <algorithm>

#include "sfumato/base/vec2.hpp"

namespace sfumato::test {

inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return length(p - (a + t * along));
}

}  // namespace sfumato::test
