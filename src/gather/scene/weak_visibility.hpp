#pragma once

#include <cstdint>
#include <vector>

#include "base/table_memory.hpp"
#include "gather/scene/scene.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Returns per triangle of the scene 1 where some point of it may see some point of Scene::watched
/// (weak visibility from edges: Avis and Toussaint 1981). Never too few, and nearly none too many:
/// windows are followed through the triangulation, bounded by the lines that touch the obstacles on
/// either side. The list is allocated from `memory`.
///
/// Errors: limit (memory), cancelled. Cost: O(windows), at most `steps_per_triangle` for each
/// triangle: if there are more, all triangles are marked. Windows that reach the same triangles by
/// several ways are followed on each way; on drawings they are a few percent of the triangles.
Result<std::vector<std::uint8_t>> find_viewers(const Context& context, const Scene& scene,
                                               TableMemory& memory, std::size_t steps_per_triangle);

}  // namespace sfumato::gather
