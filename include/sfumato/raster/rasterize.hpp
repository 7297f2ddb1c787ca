#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sfumato/base/context.hpp"
#include "sfumato/base/image.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// The place of an image in a larger one that never exists as a whole.
struct RasterWindow {
  /// The largest number of pixels on a side of the larger image: single precision holds all whole
  /// numbers up to it.
  static constexpr int kLargestSide = 1 << 24;

  int x = 0;          ///< pixels of the larger image left of this one, at least 0
  int y = 0;          ///< pixels of the larger image above this one, at least 0
  int of_width = 0;   ///< width of the larger image, which contains all of this one
  int of_height = 0;  ///< height of the larger image; its sides are at most kLargestSide
};

/// Options of rasterize(). Width and height must be set.
struct RasterOptions {
  int width = 0;   ///< pixels, 1 to Limits::image_side
  int height = 0;  ///< pixels, 1 to Limits::image_side
  /// The part of the artboard frame that fills the image; default: Picture::viewport. Beyond the
  /// latter the layers show nothing reliable.
  std::optional<Box> viewport{};
  PixelFormat format = PixelFormat::rgb8;  ///< of the image
  /// Shown where no layer covers. Default: Picture::background. Without one: transparent in formats
  /// with alpha, else white.
  std::optional<Rgb> background{};
  /// Adds blue noise below one code value where colours change slowly, so that 8 bits show no
  /// steps; even areas stay even. No effect on 16-bit formats.
  bool dither = false;
  bool antialias = true;      ///< average by exact area where curves cut pixels
  bool mesh_overlay = false;  ///< draw the edges of the triangulation on top
  /// If given, the viewport fills the larger image, and the image is a part of that, with the same
  /// bytes as when the larger image is painted as a whole or in other windows.
  std::optional<RasterWindow> window{};
};

/// Draws a picture into an image, in tiles that the context's threads share. The bytes are the same
/// for any thread count and SIMD level. Use PreparedRaster for many windows of one image.
///
/// Pixel (0, 0) lies at the viewport's upper left corner. The viewport fills the image, so that
/// pixels are not square where the two have different proportions.
///
/// A pixel shows the patch at its centre, and each centre belongs to one triangle only. Where a
/// curve cuts the pixel and RasterOptions::antialias is set, the pixel shows the mean of its
/// patches, by exact area, of premultiplied colours. A layer with PatchLayer::exact_points gathers
/// its colours instead, which takes about 1 µs a point. Layers, local curves and groups are
/// composited in sRGB code values, as in CSS (docs/mathematics.md, "Pixels").
///
/// Errors: bad_input (no pixels, an empty viewport, an invalid picture), limit (size, memory,
/// limits of the picture), cancelled, out_of_memory.
/// Memory: the image; for each thread 1 MiB, with compositing 2 MiB more and 0.3 MiB for each group
/// within a group; 12 bytes a triangle and 300 bytes an item of the stack.
/// Cost on one thread, for the area that an item of the stack covers: about 4 ns a pixel, 0.4 µs a
/// triangle and 0.1 µs a pixel that a curve cuts; compositing 2 to 6 ns a pixel more.
///
/// Tiles are 256 × 64 pixels, counted from the corner of the larger image if there is a window.
/// Tiles that a window cuts are painted whole: windows whose sides are multiples cost least.
Result<Image> rasterize(Context& context, const Picture& picture, const RasterOptions& options);

/// Does rasterize() into the caller's memory: RasterOptions::height rows of RasterOptions::width
/// pixels from `pixels` on, `row_bytes` apart. Bytes between rows are not touched; after an error
/// the pixels are unspecified.
///
/// Errors: as rasterize(); bad_input also where `pixels` is null, or `row_bytes` is less than a row
/// of pixels takes.
Status rasterize_into(Context& context, const Picture& picture, const RasterOptions& options,
                      std::uint8_t* pixels, std::size_t row_bytes);

/// A picture prepared for many windows of one image, such as map tiles: checks and tables that do
/// not depend on the window are made once. A window of few tiles then costs its pixels, and for
/// each tile 0.2 ns a triangle of the picture; a larger one 10 ns a triangle.
class PreparedRaster {
 public:
  /// Prepares a picture.
  ///
  /// - `options`: RasterOptions::width and RasterOptions::height of the whole image, up to
  ///   RasterWindow::kLargestSide; no window
  ///
  /// The picture must stay unchanged, and the context must live, as long as the object.
  /// Errors: as rasterize().
  /// Memory: 2 bytes a triangle, 300 bytes an item of the stack, local curves and textures.
  static Result<PreparedRaster> create(Context& context, const Picture& picture,
                                       const RasterOptions& options);

  /// Moves; the other object then has nothing to paint.
  PreparedRaster(PreparedRaster&& other) noexcept : parts_(other.parts_) { other.parts_ = nullptr; }
  /// Exchanges the content of both objects.
  PreparedRaster& operator=(PreparedRaster&& other) noexcept;
  ~PreparedRaster();  ///< Releases its memory.

  /// Paints the pixels [x, x + width) × [y, y + height) of the whole image, with the bytes of
  /// rasterize_into() with a window. Several threads may each paint a window at once, with their
  /// own contexts.
  Status paint(Context& context, int x, int y, int width, int height, std::uint8_t* pixels,
               std::size_t row_bytes) const;

 private:
  struct Parts;

  explicit PreparedRaster(Parts* parts) : parts_(parts) {}
  Parts* parts_;  ///< owned
};

}  // namespace sfumato
