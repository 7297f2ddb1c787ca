#pragma once

namespace sfumato {

// Without <cmath>, 10,000 lines for every reader of a header.

/// A point or vector of the plane, double precision. Artboard frame unless said otherwise: x right,
/// y down, user units.
struct Vec2 {
  double x = 0;
  double y = 0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return a * s; }
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  friend constexpr bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
};

constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}

/// Twice the signed area of (0, a, b). Positive where b is clockwise of a on the screen (y down).
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

constexpr double length_squared(Vec2 a) {
  return dot(a, a);
}

inline double length(Vec2 a) {
  return __builtin_sqrt(length_squared(a));
}

constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
  return a + (b - a) * t;
}

/// The screen left of a walking direction (y down): (dy, -dx).
constexpr Vec2 left_of(Vec2 direction) {
  return {direction.y, -direction.x};
}

inline bool is_finite(Vec2 a) {
  return __builtin_isfinite(a.x) && __builtin_isfinite(a.y);
}

}  // namespace sfumato
