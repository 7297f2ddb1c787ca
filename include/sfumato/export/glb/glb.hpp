#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

struct GlbOptions {
  /// Largest tolerated difference to the patches, in code values of 255, as programs show it that
  /// interpolate linear light.
  double max_error = 1;
  double dpi = 192;  ///< of what is stored as textures; a user unit is 1/96 inch
  double size = 1;   ///< of the viewport's longer side, metres
  /// Behind what no layer covers; default the picture's own, else nothing.
  std::optional<Rgb> background{};
};

/// Picture → glTF 2.0 in one binary file: a scene in the plane z = 0, x right, y up, the viewport's
/// centre at the origin; items of the stack lie one behind the other by up to 1/1000 of its size.
///
/// Each layer is one mesh with linear colours at its vertices (COLOR_0, 16 bits), however many
/// nodes show it; materials are unlit (KHR_materials_unlit) and show both sides. Local curves and
/// layers with image-domain shaders are rectangles with a texture. docs/outputs.md has the rest.
///
/// notes   if not null: what glTF cannot hold, and the number of triangles
/// Errors: bad_input (a picture whose tables do not fit, an empty viewport, options that are not
/// positive numbers), limit (memory, 4 GiB), cancelled.
/// Cost: about 3 µs and 34 bytes a triangle.
Result<std::vector<std::uint8_t>> export_glb(Context& context, const Picture& picture,
                                             const GlbOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
