#pragma once

#include "export/html/viewer_bytes.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The table of paints (docs/gpu.md) and the files of the textures that layers use: the viewer
/// makes the texels from these. A texture without a PNG or JPEG file is encoded as PNG. Errors:
/// limit (memory), cancelled. Cost: O(stops + texels).
Status write_paints(Context& context, const Picture& picture, ByteWriter& out);

}  // namespace sfumato::outputs
