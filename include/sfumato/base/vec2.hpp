#pragma once

namespace sfumato {

// Without <cmath>, 10,000 lines for every reader of a header.

/// A point or a vector of the plane, in double precision. Unless said otherwise it is in the
/// artboard frame: x to the right, y down, user units.
struct Vec2 {
  double x = 0;  ///< to the right
  double y = 0;  ///< down

  /// Sum by coordinate.
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  /// The vector from `b` to `a`.
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  /// The vector `s` times as long.
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
  /// The vector `s` times as long.
  friend constexpr Vec2 operator*(double s, Vec2 a) { return a * s; }
  /// The vector 1/s times as long.
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  /// Exact comparison of both coordinates.
  friend constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
};

/// The scalar product.
constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}

/// Twice the signed area of the triangle (0, a, b). Positive where b is clockwise of a on the
/// screen (y down).
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// The square of the Euclidean length.
constexpr double length_squared(Vec2 a) {
  return dot(a, a);
}

/// The Euclidean length.
inline double length(Vec2 a) {
  return __builtin_sqrt(length_squared(a));
}

/// The point from `a` at t = 0 to `b` at t = 1.
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
  return a + (b - a) * t;
}

/// The direction to the left of a walking direction, as seen on the screen (y down): (dy, -dx).
constexpr Vec2 left_of(Vec2 direction) {
  return {direction.y, -direction.x};
}

/// Whether both coordinates are neither infinite nor NaN.
inline bool is_finite(Vec2 a) {
  return __builtin_isfinite(a.x) && __builtin_isfinite(a.y);
}

}  // namespace sfumato
