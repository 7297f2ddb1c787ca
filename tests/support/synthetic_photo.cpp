#include "support/synthetic_photo.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sfumato::test {
namespace {

constexpr double kNoise = 2.0 / 255;
using Color = std::array<double, 3>;

Color mix(const Color& a, const Color& b, double t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

/// Returns 0 below `low`, 1 above `high`, and a smooth step between.
double ramp(double low, double high, double v) {
  const double t = std::clamp((v - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Returns colours without noise at x from 0 to 4/3 and y from 0 to 1; `pixel` is the width of a
/// pixel.
Color scene(double x, double y, double pixel) {
  const Color wall = mix({0.62, 0.66, 0.70}, {0.36, 0.40, 0.50}, 0.5 * x + 0.4 * y);
  const Color table = mix({0.50, 0.33, 0.22}, {0.72, 0.52, 0.36}, ramp(0.65, 1, y));
  Color color = mix(wall, table, ramp(0.65 - pixel / 2, 0.65 + pixel / 2, y));
  const double shadow = std::hypot((x - 0.62) / 0.36, (y - 0.80) / 0.07);
  color = mix(color, {0.16, 0.10, 0.08}, 0.7 * ramp(1.35, 0.55, shadow));
  const double far = std::hypot(x - 1.02, y - 0.30);
  color = mix(color, {0.93, 0.80, 0.42}, ramp(0.17, 0.09, far));
  const double bar = std::max(std::abs(x - 0.2) - 0.015, std::abs(y - 0.33) - 0.24);
  color = mix(color, {0.95, 0.95, 0.92}, ramp(pixel / 2, -pixel / 2, bar));
  const double dx = (x - 0.52) / 0.25, dy = (y - 0.56) / 0.25, r = std::hypot(dx, dy);
  const double light =
      std::max(0.0, -0.5 * dx - 0.6 * dy + 0.62 * std::sqrt(std::max(0.0, 1 - r * r)));
  Color ball = mix({0.20, 0.04, 0.05}, {0.85, 0.22, 0.16}, std::min(1.0, light));
  ball = mix(ball, {1, 0.93, 0.88}, ramp(0.22, 0.05, std::hypot(dx + 0.38, dy + 0.42)));
  return mix(color, ball, ramp(1 + 2 * pixel, 1 - 2 * pixel, r));
}

/// Returns a number from 0 to 1, the same on every machine.
double hash(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a * 0x27d4eb2fU ^ (b + 0x9e3779b9U) * 0x165667b1U;
  h = (h ^ h >> 15) * 0x85ebca6bU;
  h = (h ^ h >> 13) * 0xc2b2ae35U;
  return (h ^ h >> 16) / 4294967296.0;
}

/// Returns an approximately normal number: the sum of twelve uniform ones.
double normal(std::uint32_t index, std::uint32_t seed) {
  double sum = -6;
  for (std::uint32_t i = 0; i < 12; ++i) sum += hash(12 * index + i, seed);
  return sum;
}

}  // namespace

Image synthetic_photo(int width, std::uint32_t seed) {
  Image image{width, 3 * width / 4, PixelFormat::rgb8, {}};
  const double pixel = 4.0 / 3 / width;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const double value : scene((x + 0.5) * pixel, (y + 0.5) * pixel, pixel)) {
        const auto index = static_cast<std::uint32_t>(image.bytes.size());
        const double shown = 255 * (value + kNoise * normal(index, seed));
        image.bytes.push_back(static_cast<std::uint8_t>(std::clamp(shown + 0.5, 0.0, 255.0)));
      }
    }
  }
  return image;
}

}  // namespace sfumato::test
