#pragma once

#include <algorithm>

namespace sfumato {

/// The pixels of the image from (x0, y0) up to but not including (x1, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

inline PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// Returns `rect` grown by at least `margin` pixels on each side.
inline PixelRect grown(const PixelRect& rect, double margin) {
  const int by = static_cast<int>(margin) + 1;
  return {rect.x0 - by, rect.y0 - by, rect.x1 + by, rect.y1 + by};
}

/// Returns the smallest rectangle that contains both; empty ones are ignored.
inline PixelRect united(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace sfumato
