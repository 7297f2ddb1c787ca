#pragma once

#include <cstddef>

#include "export/html/viewer_bytes.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::outputs {

/// Writes a local curve as segments, which the viewer turns into nodes at any zoom (docs/viewer.md,
/// "Strokes"). Segments that do not reach into `viewport`, artboard units, are left out.
///
/// segment_count  number of segments written so far; increased by the segments of this stroke.
/// Errors: limit (segments, memory), cancelled. Cost: O(segments).
Status write_stroke(Context& context, const LocalStroke& stroke, InterpolationSpace space,
                    const Box& viewport, std::size_t* segment_count, ByteWriter& out);

}  // namespace sfumato::outputs
