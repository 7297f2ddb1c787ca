#pragma once

#include <vector>

#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// The part of a pixel that a layer covers, and its colour there.
struct PixelPart {
  float area = 0;        ///< below 1
  float moment[2] = {};  ///< area times centroid, from the pixel's upper left corner
  float color[4] = {};   ///< mean over the part, premultiplied
};

/// Layers whose outlines abut within a pixel. If they were painted one over the other by coverage
/// alone, the background would show through between the two parts. Parts that together fill the
/// pixel exactly once, according to their areas and their common centroid, are added instead.
///
/// One object serves one tile, whose layers are painted one after another.
class AbuttingParts {
  struct Pixel {
    PixelPart sum;       ///< colours weighted by area
    float left[4] = {};  ///< the value after the last part
  };

 public:
  /// Upper bound of the memory of one object.
  static constexpr std::size_t kMostBytes = std::size_t{kTileWidth} * kTileHeight * sizeof(Pixel);

  /// Removes the data of the previous tile.
  void clear() { pixels_.clear(); }

  /// Paints an opaque part over the pixel's previous value `below`. Values are colour and alpha;
  /// alpha is 1 in images without alpha.
  void paint(int x, int y, const PixelPart& part, const float (&below)[4], float (&out)[4]);

 private:
  std::vector<Pixel> pixels_;
};

}  // namespace sfumato::raster
