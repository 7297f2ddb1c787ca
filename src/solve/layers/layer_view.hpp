#pragma once

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::solve {

/// Returns the bounding box of a mapped rectangle.
inline Box bounds_of_mapped(const Affine& map, const Box& box) {
  Box bounds;
  for (Vec2 corner : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}}) {
    bounds.extend(map(corner));
  }
  return bounds;
}

}  // namespace sfumato::solve
