#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato {

/// Orders points so that neighbours in the list are mostly neighbours in the plane: returns their
/// indices by the cells of a Z-order curve, within a cell in the given order. `order` is allocated
/// from `memory`. Errors: limit (memory), cancelled. Cost: O(points).
Status spatial_order(const Context& context, std::span<const Vec2> points, TableMemory& memory,
                     std::vector<std::uint32_t>& order);

}  // namespace sfumato
