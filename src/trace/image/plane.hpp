#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::tracing {

/// One number to a pixel. Pixel (x, y) has its centre at (x + 1/2, y + 1/2) and stands at
/// value[y * width + x].
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> value;

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  float* row(int y) { return value.data() + index(0, y); }
  const float* row(int y) const { return value.data() + index(0, y); }
  float at(int x, int y) const { return value[index(x, y)]; }

  /// Bilinear between the centres of pixels; outside them the nearest.
  float sample(Vec2 p) const {
    const double x = std::clamp(p.x - 0.5, 0.0, width - 1.0);
    const double y = std::clamp(p.y - 0.5, 0.0, height - 1.0);
    const int x0 = std::min(static_cast<int>(x), std::max(width - 2, 0));
    const int y0 = std::min(static_cast<int>(y), std::max(height - 2, 0));
    const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    const float upper = at(x0, y0) + fx * (at(x1, y0) - at(x0, y0));
    const float lower = at(x0, y1) + fx * (at(x1, y1) - at(x0, y1));
    return upper + fy * (lower - upper);
  }
};

/// A plane of zeros. Errors: limit (memory), cancelled.
inline Status make_plane(const Context& context, int width, int height, TableMemory& memory,
                         Plane& plane) {
  plane.width = width;
  plane.height = height;
  return memory.resize(context, plane.value,
                       static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

/// Red, green and blue, or another three channels of a picture.
using Channels = std::array<Plane, 3>;

}  // namespace sfumato::tracing
