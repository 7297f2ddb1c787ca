#pragma once

#include "export/html/viewer_bytes.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The exact fields of the layers, the last part of a payload (docs/viewer.md); nothing where no
/// layer has any. Errors: limit (memory), cancelled.
Status write_exact(Context& context, const Picture& picture, ByteWriter& out);

}  // namespace sfumato::outputs
