#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// Indices of the points in an order in which neighbours in the plane are mostly neighbours in the
/// list: by the cells of a Z-order curve, within a cell as given. Cost: O(points).
std::vector<std::uint32_t> spatial_order(std::span<const Vec2> points);

/// The same, in a table that takes its room from `memory`. Errors: limit (memory), cancelled.
Status spatial_order(Context& context, std::span<const Vec2> points, TableMemory& memory,
                     std::vector<std::uint32_t>& order);

}  // namespace sfumato
