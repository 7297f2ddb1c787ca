#pragma once

#include <algorithm>
#include <utility>

#include "sfumato/base/box.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// Returns the point of the segment from a to b that is nearest to p. The segment may have no
/// length.
inline Vec2 nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = length_squared(along);
  return lerp(a, b, square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0);
}

/// Returns the part of the segment from a to b, as fractions of its way, that lies in a box; from
/// above to where there is none.
inline std::pair<double, double> part_within(const Box& box, Vec2 a, Vec2 b) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double first = (low - start) / step, second = (high - start) / step;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  };
  cut(a.x, b.x - a.x, box.min.x, box.max.x);
  cut(a.y, b.y - a.y, box.min.y, box.max.y);
  return {from, to};
}

}  // namespace sfumato
