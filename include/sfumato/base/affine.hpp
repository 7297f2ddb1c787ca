#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// An affine map; columns as in SVG's matrix(a b c d e f): (x, y) → (a x + c y + e, b x + d y + f).
/// Name a value target_from_source, so that products check by eye.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  constexpr Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

  constexpr double determinant() const { return a * d - b * c; }

  /// (r * s)(p) == r(s(p)).
  friend constexpr Affine operator*(const Affine& r, const Affine& s) {
    return {r.a * s.a + r.c * s.b, r.b * s.a + r.d * s.b,       r.a * s.c + r.c * s.d,
            r.b * s.c + r.d * s.d, r.a * s.e + r.c * s.f + r.e, r.b * s.e + r.d * s.f + r.f};
  }

  friend constexpr bool operator==(const Affine&, const Affine&) = default;
};

/// Precondition: determinant() != 0.
constexpr Affine inverse(const Affine& m) {
  const double k = 1 / m.determinant();
  const Affine linear{m.d * k, -m.b * k, -m.c * k, m.a * k, 0, 0};
  const Vec2 origin = linear({m.e, m.f});
  return {linear.a, linear.b, linear.c, linear.d, -origin.x, -origin.y};
}

}  // namespace sfumato
