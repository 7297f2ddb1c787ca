#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// A closed rectangle with sides parallel to the axes. The default is empty, with `min` at
/// +infinity and `max` at -infinity, so that `extend` can gather points from nothing.
struct Box {
  Vec2 min{__builtin_huge_val(), __builtin_huge_val()};    ///< the corner with the smallest x and y
  Vec2 max{-__builtin_huge_val(), -__builtin_huge_val()};  ///< the corner with the largest x and y

  /// Returns whether it holds no point. A box of width or height 0 is not empty.
  bool empty() const { return !(min.x <= max.x && min.y <= max.y); }
  /// Returns the extent in x. Meaningless for an empty box.
  double width() const { return max.x - min.x; }
  /// Returns the extent in y. Meaningless for an empty box.
  double height() const { return max.y - min.y; }
  /// Returns the midpoint. Meaningless for an empty box.
  Vec2 center() const { return (min + max) * 0.5; }

  /// Returns whether the point lies inside or on the boundary.
  bool contains(Vec2 p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
  }

  /// Grows just enough to contain the point. A coordinate that is NaN changes nothing.
  void extend(Vec2 p) {
    if (p.x < min.x) min.x = p.x;
    if (p.y < min.y) min.y = p.y;
    if (max.x < p.x) max.x = p.x;
    if (max.y < p.y) max.y = p.y;
  }

  /// Returns the box with all four sides moved outwards by `margin`, or inwards where it is
  /// negative.
  Box grown_by(double margin) const {
    return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
  }

  /// Compares the corners exactly.
  friend bool operator==(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }
};

/// Returns the smallest box that contains both boxes; either may be empty.
inline Box united(const Box& a, const Box& b) {
  return {{b.min.x < a.min.x ? b.min.x : a.min.x, b.min.y < a.min.y ? b.min.y : a.min.y},
          {a.max.x < b.max.x ? b.max.x : a.max.x, a.max.y < b.max.y ? b.max.y : a.max.y}};
}

/// Returns whether the two boxes share a point; a common boundary is enough.
inline bool overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace sfumato
