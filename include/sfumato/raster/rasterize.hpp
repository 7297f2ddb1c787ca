#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// Where an image lies in a larger one that is never there as a whole.
struct RasterWindow {
  /// Pixels on a side of the larger image at most: single precision has all whole numbers up to it.
  static constexpr int kLargestSide = 1 << 24;

  int x = 0;          ///< pixels of the larger image left of this one, at least 0
  int y = 0;          ///< pixels above it, at least 0
  int of_width = 0;   ///< of the larger image, which holds all of this one
  int of_height = 0;  ///< of the larger image; its sides are at most kLargestSide
};

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
  /// If given, the viewport fills the larger image, and the image is a part of that: to the byte
  /// what stands there when it is painted as a whole or in other windows.
  std::optional<RasterWindow> window{};
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
///
/// Tiles are 256 × 64 pixels, counted from the corner of the larger image if there is a window, and
/// those that a window cuts are painted whole: windows whose sides are multiples cost least.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options);

/// The same into memory of the caller's: RasterOptions::height rows of RasterOptions::width pixels
/// from `pixels` on, `row_bytes` apart. What lies between rows is not touched; after an error the
/// pixels are unspecified.
///
/// Errors: those of rasterize(); bad_input also where `pixels` is null, or `row_bytes` less than a
/// row of pixels takes.
Status rasterize_into(Context& context, const Picture& picture, const RasterOptions& options,
                      std::uint8_t* pixels, std::size_t row_bytes);

/// A picture made ready for many windows of one image, as map tiles are: what does not depend on
/// the window is checked and prepared once. A window of few tiles then costs its pixels, and for
/// each tile 0.2 ns a triangle of the picture; a larger one 10 ns a triangle.
class PreparedRaster {
 public:
  /// options  RasterOptions::width and RasterOptions::height are those of the whole image, up to
  ///          RasterWindow::kLargestSide; no window
  /// The picture must stay as it is, and the context must live, as long as the object.
  /// Errors: those of rasterize().
  /// Memory: 2 bytes a triangle, 300 bytes an item of the stack, local curves and textures.
  static Result<PreparedRaster> create(Context& context, const Picture& picture,
                                       const RasterOptions& options);

  /// Leaves nothing to paint behind.
  PreparedRaster(PreparedRaster&& other) noexcept : parts_(other.parts_) { other.parts_ = nullptr; }
  /// Exchanges what the two hold.
  PreparedRaster& operator=(PreparedRaster&& other) noexcept;
  ~PreparedRaster();  ///< gives its memory back

  /// Paints the pixels [x, x + width) × [y, y + height) of the whole image, as rasterize_into()
  /// does with a window; the same bytes. Several threads may each paint a window at once, with a
  /// context of their own.
  Status paint(Context& context, int x, int y, int width, int height, std::uint8_t* pixels,
               std::size_t row_bytes) const;

 private:
  struct Parts;

  explicit PreparedRaster(Parts* parts) : parts_(parts) {}
  Parts* parts_;  ///< owned
};

}  // namespace sfumato
