#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::raster {

/// Returns per triangle of a checked layer 1 if some value deviates from a linear function on the
/// triangle by more than a few code values. The mean over a part may then differ from the value at
/// the part's centroid. Errors: limit (memory), cancelled. Cost: O(triangles).
Result<std::vector<std::uint8_t>> bent_triangles(Context& context, const PatchLayer& layer,
                                                 TableMemory& memory);

}  // namespace sfumato::raster
