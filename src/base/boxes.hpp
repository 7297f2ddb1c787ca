#pragma once

#include <algorithm>
#include <span>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato {

/// Returns the points that two boxes share; empty if there are none.
inline Box intersection(const Box& a, const Box& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// Returns the bounds of a mapped box, which is not empty.
inline Box mapped_box(const Affine& map, const Box& box) {
  Box mapped;
  for (const Vec2 corner : {box.min, box.max, Vec2{box.min.x, box.max.y}, {box.max.x, box.min.y}})
    mapped.extend(map(corner));
  return mapped;
}

/// Returns the smallest box that contains the points; empty without points.
inline Box box_of_points(std::span<const Vec2> points) {
  Box box;
  for (const Vec2 p : points) box.extend(p);
  return box;
}

/// Returns the length of the longer side.
inline double longer_side(const Box& box) {
  return std::max(box.width(), box.height());
}

}  // namespace sfumato
