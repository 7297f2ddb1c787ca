#pragma once

namespace sfumato {

// Includes no <cmath>, which would add 10,000 lines to each file that includes this header.

/// A point or a vector of the plane, in double precision. Unless said otherwise it is in the
/// artboard frame: x to the right, y down, user units.
struct Vec2 {
  double x = 0;  ///< to the right
  double y = 0;  ///< down

  /// Adds the coordinates.
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  /// Returns the vector from `b` to `a`.
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  /// Returns the vector `s` times as long.
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
  /// Returns the vector `s` times as long.
  friend constexpr Vec2 operator*(double s, Vec2 a) { return a * s; }
  /// Returns the vector 1/s times as long.
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  /// Compares both coordinates exactly.
  friend constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
};

/// Returns the scalar product.
constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}

/// Returns twice the signed area of the triangle (0, a, b). Positive where b is clockwise of a on
/// the screen (y down).
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Returns the square of the Euclidean length.
constexpr double length_squared(Vec2 a) {
  return dot(a, a);
}

/// Returns the Euclidean length.
inline double length(Vec2 a) {
  return __builtin_sqrt(length_squared(a));
}

/// Returns the point from `a` at t = 0 to `b` at t = 1.
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
  return a + (b - a) * t;
}

/// Returns the direction to the left of a walking direction, as seen on the screen (y down): (dy,
/// -dx).
constexpr Vec2 left_of(Vec2 direction) {
  return {direction.y, -direction.x};
}

/// Returns whether both coordinates are neither infinite nor NaN.
inline bool is_finite(Vec2 a) {
  return __builtin_isfinite(a.x) && __builtin_isfinite(a.y);
}

}  // namespace sfumato
