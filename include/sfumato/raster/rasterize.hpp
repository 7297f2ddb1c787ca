#pragma once

#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// How a picture becomes pixels. Width and height have to be set.
struct RasterOptions {
  int width = 0;   ///< pixels, 1 to Limits::image_side
  int height = 0;  ///< pixels, 1 to Limits::image_side
  /// The part of the artboard frame that fills the image; default: Picture::viewport. Outside the
  /// latter the layers show nothing reliable.
  std::optional<Box> viewport{};
  PixelFormat format = PixelFormat::rgb8;  ///< of the image
  /// Shown where no layer covers. Default: Picture::background, or if that is empty white, in
  /// formats with alpha transparent.
  std::optional<Rgb> background{};
  /// Adds blue noise below one code value where colours change slowly, so that 8 bits show no
  /// steps; even areas stay even. No effect on 16-bit formats.
  bool dither = false;
  bool antialias = true;      ///< average by exact area where curves cut pixels
  bool mesh_overlay = false;  ///< draw the edges of the triangulation on top
};

/// Picture → Image, in tiles that the context's threads share. The bytes are the same for any
/// thread count and SIMD level.
///
/// Pixel (0, 0) lies at the viewport's upper left corner. The viewport fills the image, so that
/// pixels are not square where the two have different proportions.
///
/// A pixel shows the patch at its centre, and each centre belongs to one triangle only. Where a
/// curve cuts the pixel and RasterOptions::antialias is set, it shows the mean of the patches in
/// it, by exact area, of premultiplied colours. Layers, local curves and groups are composited in
/// sRGB code values, as in CSS (docs/mathematics.md, "Pixels").
///
/// Errors: bad_input (no pixels, an empty viewport, an invalid picture), limit (size, memory,
/// limits of the picture), cancelled, out_of_memory.
/// Memory: the image; for each thread 1 MiB, where anything is composited 2 MiB more and 0.3 MiB
/// for each group within a group; 12 bytes a triangle and 300 bytes an item of the stack.
/// Cost on one thread, for what an item of the stack covers: about 4 ns a pixel, 0.4 µs a triangle
/// and 0.1 µs a pixel that a curve cuts; 2 to 6 ns a pixel more for what has to be composited.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options);

}  // namespace sfumato
