#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/export/export_notes.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato {

/// Options of export_glb().
struct GlbOptions {
  /// Largest tolerated difference from the patches, in code values of 255, in a program that
  /// interpolates vertex colours in linear light.
  double max_error = 1;
  double dpi = 192;  ///< resolution of parts stored as textures; a user unit is 1/96 inch
  double size = 1;   ///< length of the viewport's longer side in the scene, metres
  /// Shown where no layer covers; default: Picture::background, or none.
  std::optional<Rgb> background{};
};

/// Exports a picture as glTF 2.0 in one binary file (docs/outputs.md): a flat scene with x to the
/// right, y up and the viewport's centre at the origin. Each item of the stack lies in front of the
/// one before by at most 1/1000 of the viewport's longer side, and all of them within 1/10 of it.
///
/// Each layer is one mesh with linear colours at its vertices (COLOR_0, 16 bits), however many
/// nodes show it. Materials are unlit (KHR_materials_unlit) and show both sides. Local curves and
/// layers with image-domain shaders are rectangles with a texture. `notes`, unless null, receives
/// the content that glTF cannot hold and the number of triangles.
///
/// Errors: bad_input (an invalid picture, an empty viewport, options that are not positive
/// numbers), limit (memory, 2 GiB), cancelled, out_of_memory.
/// Cost: about 3 µs and 34 bytes a triangle.
Result<std::vector<std::uint8_t>> export_glb(Context& context, const Picture& picture,
                                             const GlbOptions& options,
                                             ExportNotes* notes = nullptr);

}  // namespace sfumato
