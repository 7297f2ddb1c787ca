#pragma once

#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

struct RasterOptions {
  int width = 0;   ///< pixels, 1 to limits::kImageSide
  int height = 0;  ///< pixels
  /// The part of the artboard that fills the image; default Picture::viewport.
  std::optional<Box> viewport{};
  PixelFormat format = PixelFormat::rgb8;
  /// Behind what no layer covers; default the picture's own, else white, or in formats with alpha
  /// transparent.
  std::optional<Rgb> background{};
  /// 8-bit formats only: blue noise below a code value where colours change; what is even stays so.
  bool dither = false;
  bool antialias = true;      ///< exact area coverage where curves cut pixels
  bool mesh_overlay = false;  ///< draw the triangulation's edges on top
};

/// Picture → Image on the pool: in tiles of a fixed size, the same bytes for any thread count and
/// SIMD level. Image pixel (0, 0) lies at the viewport's upper left corner; the viewport fills the
/// image, so that pixels need not be square.
///
/// A pixel shows the patch at its centre; where a curve passes through it and `antialias` is set,
/// the mean of the patches in it by exact area, of premultiplied colours. Each centre belongs to
/// one triangle only. Layers, strokes and groups are composited in sRGB code values, as CSS has it
/// (docs/mathematics.md, "Pixels").
///
/// Errors: bad_input (no pixels, an empty viewport, a picture whose tables do not fit), limit
/// (size, memory, limits of the picture), cancelled.
/// Memory: the image, 1 MiB a thread, with compositing 2 MiB and 0.3 MiB for each group within a
/// group; 12 bytes a triangle, 300 an item of the stack. Cost: about 4 ns a pixel, 0.4 µs a
/// triangle and 0.1 µs a pixel that a curve cuts, on one thread, for what an item covers; 2 to 6 ns
/// a pixel more for what is not painted straight.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options);

}  // namespace sfumato
