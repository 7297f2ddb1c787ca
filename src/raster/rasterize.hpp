#pragma once

#include <optional>

#include "base/context.hpp"
#include "base/image.hpp"
#include "base/status.hpp"
#include "patches/picture.hpp"

namespace sfumato {

struct RasterOptions {
  int width = 0;   ///< pixels, 1 to limits::kImageSide
  int height = 0;  ///< pixels
  /// The part of the artboard that fills the image; default Picture::viewport.
  std::optional<Box> viewport;
  PixelFormat format = PixelFormat::rgb8;
  /// Over transparent pixels of formats without alpha; default white.
  std::optional<Rgb> background;
  bool dither = false;        ///< ordered 8×8 dither, 8-bit formats only
  bool antialias = true;      ///< exact area coverage where curves cut pixels
  bool mesh_overlay = false;  ///< draw the triangulation's edges on top
};

/// Picture → Image on the pool: in horizontal bands of a fixed height, the same bytes for any
/// thread count and SIMD level. Errors: limit (size, memory), cancelled.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options);

}  // namespace sfumato
