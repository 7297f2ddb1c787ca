#include "raster/kernels/texture_kernels.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::raster {
namespace {

/// Larger coordinates are reduced to this; NaN becomes its negative.
constexpr double kLargestCoordinate = 1e12;

}  // namespace

double TextureAxis::reduced(double x) const {
  if (x >= 0 && x < period) return x;
  x = x > -kLargestCoordinate ? (x < kLargestCoordinate ? x : kLargestCoordinate)
                              : -kLargestCoordinate;
  if (!repeats) return std::clamp(x, -period - 2, 2 * period + 2);
  x -= period * std::floor(x / period);
  return x >= 0 && x < period ? x : 0;
}

int TextureAxis::texel(int i) const {
  if (i >= 0 && i < count) return i;
  if (!repeats) return i < 0 ? 0 : count - 1;
  return std::min(static_cast<int>(reduced(i + 0.5)), count - 1);
}

}  // namespace sfumato::raster
