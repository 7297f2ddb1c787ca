#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::svg {

/// A vertex of a shape: where a segment begins or ends.
struct MarkerVertex {
  Vec2 point;
  Vec2 direction;  ///< of the path there, a unit vector
};

/// Returns the vertices of a shape in the order of the path, with directions as SVG 2, 9.5.1 says:
/// half-way between the segments that meet, also where a closed subpath begins and ends. A segment
/// of no length has the direction of the one before it. Errors: limit (memory), cancelled.
Result<std::vector<MarkerVertex>> marker_vertices(const Context& context,
                                                  std::span<const Subpath> subpaths,
                                                  TableMemory& memory);

}  // namespace sfumato::svg
