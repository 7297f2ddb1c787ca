#include "color/hue.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::color {
namespace {

/// Returns one channel of the pure hue; CSS Color 4, section 7.1. `n`: 0 for red, 8 green, 4 blue.
double hsl_channel(double n, double turns, double saturation, double lightness) {
  const double k = std::fmod(n + turns * 12, 12.0);
  const double a = saturation * std::min(lightness, 1 - lightness);
  return lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
}

}  // namespace

Rgb rgb_from_hsl(double turns, double saturation, double lightness) {
  const auto channel = [&](double n) {
    return static_cast<float>(std::clamp(hsl_channel(n, turns, saturation, lightness), 0.0, 1.0));
  };
  return {channel(0), channel(8), channel(4)};
}

Rgb rgb_from_hwb(double turns, double white, double black) {
  if (white + black >= 1) {
    const auto gray = static_cast<float>(white / (white + black));
    return {gray, gray, gray};
  }
  const auto channel = [&](double n) {
    return static_cast<float>(hsl_channel(n, turns, 1, 0.5) * (1 - white - black) + white);
  };
  return {channel(0), channel(8), channel(4)};
}

}  // namespace sfumato::color
