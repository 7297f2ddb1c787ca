#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "sfumato/base/vec2.hpp"
#include "trace/image/plane.hpp"

namespace sfumato::test {

/// Returns the plane of value(p) at the pixels' centres p.
template <class Value>
tracing::Plane plane_of(int width, int height, Value value) {
  tracing::Plane plane{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      plane.value.push_back(static_cast<float>(value(Vec2{x + 0.5, y + 0.5})));
    }
  }
  return plane;
}

/// Returns the share of each pixel inside a shape whose border is distance(p) away; negative
/// outside.
template <class Distance>
tracing::Plane cover_plane(int width, int height, Distance distance) {
  constexpr int kParts = 8;
  return plane_of(width, height, [&](Vec2 p) {
    int inside = 0;
    for (int i = 0; i < kParts * kParts; ++i) {
      const Vec2 part{(i % kParts + 0.5) / kParts - 0.5, (i / kParts + 0.5) / kParts - 0.5};
      inside += distance(p + part) > 0;
    }
    return inside / double{kParts * kParts};
  });
}

/// Returns approximately the same for one pixel.
inline double cover(double distance) {
  return std::clamp(0.5 + distance, 0.0, 1.0);
}

/// Returns a step from 0 to 1 blurred by a Gaussian; 0: a sharp one.
inline double blurred_step(double distance, double sigma) {
  return sigma > 0 ? 0.5 + 0.5 * std::erf(distance / (sigma * std::numbers::sqrt2))
                   : cover(distance);
}

inline void add_noise(tracing::Plane& plane, double deviation, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, static_cast<float>(deviation));
  for (float& value : plane.value) value += noise(random);
}

}  // namespace sfumato::test
