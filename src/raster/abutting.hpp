#pragma once

#include <vector>

#include "raster/kernels/tile.hpp"

namespace sfumato::raster {

/// The part of a pixel that a layer covers, and what the layer shows there.
struct PixelPart {
  float area = 0;        ///< below 1
  float moment[2] = {};  ///< area times centroid, from the pixel's upper left corner
  float color[4] = {};   ///< mean over the part, premultiplied
};

/// Layers whose outlines abut within a pixel. Painted one over the other, by coverage alone, each
/// would let a share of what lies below through the other's part. Parts that fill the pixel just
/// once, which their area and their common centroid tell, are added up instead.
///
/// Of one tile, whose layers are painted one after another.
class AbuttingParts {
  struct Pixel {
    PixelPart sum;       ///< colours weighted by area
    float left[4] = {};  ///< what was painted last
  };

 public:
  /// Memory of one.
  static constexpr std::size_t kMostBytes = std::size_t{kTileWidth} * kTileHeight * sizeof(Pixel);

  /// Forgets the tile before.
  void clear() { pixels_.clear(); }

  /// Puts an opaque part onto what the pixel of the image held below it. Values are colour and
  /// alpha, 1 where none is kept.
  void paint(int x, int y, const PixelPart& part, const float (&below)[4], float (&out)[4]);

 private:
  std::vector<Pixel> pixels_;
};

}  // namespace sfumato::raster
