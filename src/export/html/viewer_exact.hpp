#pragma once

#include <cstdint>
#include <vector>

#include "export/html/viewer_bytes.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::outputs {

/// The exact fields of the layers, the last part of a payload (docs/viewer.md); nothing where no
/// layer has any. Errors: limit (memory), cancelled.
Status write_exact(Context& context, const Picture& picture, ByteWriter& out);

/// Returns the same for a single layer, whose positions have their own grid: 26 bits on each axis.
/// `space`: for interpolating colours. Errors: limit (memory), cancelled.
Result<std::vector<std::uint8_t>> exact_alone(Context& context, const ExactLayer& layer,
                                              InterpolationSpace space);

}  // namespace sfumato::outputs
