#pragma once

#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// An affine map of the plane, with the coefficients of SVG's `matrix(a b c d e f)`:
/// (x, y) → (a x + c y + e, b x + d y + f). The default is the identity.
///
/// Maps are named target_from_source throughout, so that products can be checked by eye:
/// `artboard_from_texture = artboard_from_layer * layer_from_texture`.
struct Affine {
  /// @name Coefficients
  /// @{

  /// One coefficient of the map: a to d are its linear part, (e, f) is the image of the origin.
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  /// @}

  /// Returns the image of a point, translation included.
  constexpr Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

  /// Returns the factor by which the map scales areas; negative where it mirrors.
  constexpr double determinant() const { return a * d - b * c; }

  /// Returns the map that applies `s` first: (r * s)(p) == r(s(p)).
  friend constexpr Affine operator*(const Affine& r, const Affine& s) {
    return {r.a * s.a + r.c * s.b, r.b * s.a + r.d * s.b,       r.a * s.c + r.c * s.d,
            r.b * s.c + r.d * s.d, r.a * s.e + r.c * s.f + r.e, r.b * s.e + r.d * s.f + r.f};
  }

  /// Compares all coefficients exactly.
  friend constexpr bool operator==(const Affine&, const Affine&) = default;
};

/// Returns the inverse of `m`. Precondition: `m.determinant()` is not 0.
constexpr Affine inverse(const Affine& m) {
  const double k = 1 / m.determinant();
  const Affine linear{m.d * k, -m.b * k, -m.c * k, m.a * k, 0, 0};
  const Vec2 origin = linear({m.e, m.f});
  return {linear.a, linear.b, linear.c, linear.d, -origin.x, -origin.y};
}

}  // namespace sfumato
