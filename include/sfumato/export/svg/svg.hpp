#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

enum class SvgMode : std::uint8_t {
  image,  ///< the picture's pixels in an <image>: right in every program
  vector  ///< triangles with gradients: sharp at any zoom, heavy (docs/outputs.md)
};

struct SvgOptions {
  SvgMode mode = SvgMode::image;
  double scale = 1;  ///< CSS pixels, of which 96 are an inch, to a user unit
  double dpi = 192;  ///< of what is stored as pixels
  /// Behind what no layer covers; default the picture's own, else nothing.
  std::optional<Rgb> background{};
  /// vector: largest tolerated difference to the patches, in code values of 255.
  double max_error = 2;
  bool force = false;  ///< vector: even beyond limits::kSvgTriangles
};

/// Picture → SVG of the picture's viewport, in user units.
///
/// vector: each layer is stored once, as three meshes, of red, green and blue, of triangles that
/// plain linear gradients fill, screened onto each other (docs/outputs.md, "SVG of triangles").
/// Local curves and layers with image-domain shaders stand between them as images.
///
/// notes   if not null: what is stored as pixels, and a warning above limits::kSvgTrianglesSlow
/// Errors: bad_input (a picture whose tables do not fit, an empty viewport, scale, dpi or max_error
/// that are not positive numbers), limit (size of the image, memory, limits::kSvgTriangles unless
/// forced), cancelled.
/// Cost: that of rasterize(); vector: about 400 bytes a triangle.
Result<std::vector<std::uint8_t>> export_svg(Context& context, const Picture& picture,
                                             const SvgOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
