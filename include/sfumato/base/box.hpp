#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// An axis-parallel rectangle. The default is empty: `extend` gives it its first point.
struct Box {
  Vec2 min{__builtin_huge_val(), __builtin_huge_val()};
  Vec2 max{-__builtin_huge_val(), -__builtin_huge_val()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y); }
  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
  Vec2 center() const { return (min + max) * 0.5; }

  bool contains(Vec2 p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
  }

  void extend(Vec2 p) {
    if (p.x < min.x) min.x = p.x;
    if (p.y < min.y) min.y = p.y;
    if (max.x < p.x) max.x = p.x;
    if (max.y < p.y) max.y = p.y;
  }

  Box grown_by(double margin) const {
    return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
  }

  friend bool operator==(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }
};

inline Box united(const Box& a, const Box& b) {
  return {{b.min.x < a.min.x ? b.min.x : a.min.x, b.min.y < a.min.y ? b.min.y : a.min.y},
          {a.max.x < b.max.x ? b.max.x : a.max.x, a.max.y < b.max.y ? b.max.y : a.max.y}};
}

inline bool overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace sfumato
