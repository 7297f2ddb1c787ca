#include "raster/coverage/abutting.hpp"

#include <algorithm>
#include <cmath>

namespace sfumato::raster {
namespace {

/// Tolerance for the areas and moments of parts that fill a pixel: they are 1 and 1/2, apart from
/// rounding, also of vertices.
constexpr float kRounding = 1e-3f;

bool fills_pixel(const PixelPart& sum) {
  return std::fabs(sum.area - 1) < kRounding && std::fabs(sum.moment[0] - 0.5f) < kRounding &&
         std::fabs(sum.moment[1] - 0.5f) < kRounding;
}

}  // namespace

void AbuttingParts::paint(int x, int y, const PixelPart& part, const float (&below)[4],
                          float (&out)[4]) {
  if (pixels_.empty()) pixels_.resize(std::size_t{kTileWidth} * kTileHeight);
  // Tiles are cut starting at the image's corner.
  Pixel& pixel = pixels_[static_cast<std::size_t>(y % kTileHeight) * kTileWidth +
                         static_cast<std::size_t>(x % kTileWidth)];
  const bool is_next = pixel.sum.area > 0 && std::equal(below, below + 4, pixel.left);
  if (!is_next) pixel.sum = PixelPart{};
  PixelPart& sum = pixel.sum;
  sum.area += part.area;
  for (int i = 0; i < 2; ++i) sum.moment[i] += part.moment[i];
  for (int c = 0; c < 4; ++c) sum.color[c] += part.area * part.color[c];
  const bool fills = is_next && fills_pixel(sum);
  for (int c = 0; c < 4; ++c) {
    out[c] =
        fills ? sum.color[c] / sum.area : part.area * part.color[c] + (1 - part.area) * below[c];
  }
  // An opaque pixel stays opaque to the last bit, because it is compared with the result where no
  // alpha is kept.
  if (below[3] == 1) out[3] = 1;
  std::copy_n(out, 4, pixel.left);
}

}  // namespace sfumato::raster
