#pragma once

namespace sfumato {

/// A colour in sRGB code values from 0 to 1, where 1 is the 255 of 8 bits. It has no alpha, and is
/// never premultiplied by one.
struct Rgb {
  float r = 0;  ///< red
  float g = 0;  ///< green
  float b = 0;  ///< blue

  /// Compares the channels exactly.
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// Interpolates each channel linearly, from `a` at t = 0 to `b` at t = 1.
constexpr Rgb lerp(const Rgb& a, const Rgb& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

/// Interpolates linearly from `a` at t = 0 to `b` at t = 1.
constexpr float lerp(float a, float b, float t) {
  return a + (b - a) * t;
}

}  // namespace sfumato
