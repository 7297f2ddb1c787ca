#pragma once

namespace sfumato {

/// A colour in sRGB code values, 0 to 1 (255 of 8 bits is 1). Not premultiplied.
struct Rgb {
  float r = 0;
  float g = 0;
  float b = 0;

  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr Rgb lerp(const Rgb& a, const Rgb& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

constexpr float lerp(float a, float b, float t) {
  return a + (b - a) * t;
}

}  // namespace sfumato
