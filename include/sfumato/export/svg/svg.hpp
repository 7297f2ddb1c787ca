#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// How an SVG holds a picture.
enum class SvgMode : std::uint8_t {
  image,  ///< its pixels in an `<image>`: shown correctly by every program
  vector  ///< triangles with gradients: sharp at any zoom, but heavy (docs/outputs.md)
};

/// Options of export_svg().
struct SvgOptions {
  SvgMode mode = SvgMode::image;  ///< pixels or triangles
  double scale = 1;               ///< CSS pixels, 96 to an inch, to a user unit
  double dpi = 192;               ///< resolution of parts stored as pixels
  /// Shown where no layer covers; default: Picture::background, or none.
  std::optional<Rgb> background{};
  /// SvgMode::vector: largest tolerated difference from the patches, in code values of 255.
  double max_error = 2;
  bool force = false;  ///< SvgMode::vector: ignore Limits::svg_triangles
};

/// Exports a picture as SVG of the picture's viewport, in user units. Use write_svg() to save the
/// document itself.
///
/// With SvgMode::vector each layer is stored once, as three meshes for red, green and blue,
/// screened onto each other, of triangles filled by plain linear gradients (docs/outputs.md, "SVG
/// of triangles"). Local curves and layers with image-domain shaders are images between them.
/// `notes`, unless null, receives the number of triangles, whether any part is stored as pixels,
/// and a warning above limits::kSvgTrianglesSlow; nothing for SvgMode::image.
///
/// Errors: bad_input (an invalid picture, an empty viewport, options that are not positive
/// numbers), limit (size of the image, memory, Limits::svg_triangles), cancelled, out_of_memory.
/// Cost: that of rasterize(); for SvgMode::vector about 400 bytes a triangle.
Result<std::vector<std::uint8_t>> export_svg(Context& context, const Picture& picture,
                                             const SvgOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
