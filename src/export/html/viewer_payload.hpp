#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sfumato/base/color.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// Returns the viewer's background: the requested one, else the picture's own, else white.
Rgb viewer_background(const Picture& picture, const std::optional<Rgb>& wanted);

/// Returns a picture as the bytes that the HTML viewer reads (docs/viewer.md, "Payload"), not yet
/// deflated. The error of positions is at most 2⁻²³ of the layer's extent, that of node values a
/// quarter of an 8-bit step.
///
/// Errors: bad_input (a picture whose tables are inconsistent), limit (kViewerTriangles,
/// kViewerStrokeSegments, memory), cancelled. Cost: about 1 µs a triangle.
Result<std::vector<std::uint8_t>> viewer_payload(Context& context, const Picture& picture,
                                                 const Rgb& background);

/// Returns the same bytes without meshes and fields: for each layer its order and the shaders of
/// its fields. Precondition: the picture's tables are consistent, as in a solved picture.
///
/// Errors: bad_input (no area), limit (kViewerStrokeSegments, memory), cancelled. Cost: that of the
/// strokes and the textures' files, whatever the layers hold.
Result<std::vector<std::uint8_t>> viewer_stack(Context& context, const Picture& picture,
                                               const Rgb& background);

}  // namespace sfumato::outputs
