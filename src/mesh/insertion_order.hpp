#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "mesh/lattice.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::mesh {

/// Returns the indices of `points` in a biased randomised order (Amenta, Choi, Rote 2003): rounds
/// that double in size, each along a Hilbert curve, so that walks are short for any input order. A
/// point's round is a hash of its index, hence deterministic. The list is allocated from `memory`.
/// Errors: limit (memory), cancelled. Cost: O(n).
Result<std::vector<std::uint32_t>> insertion_order(const Context& context,
                                                   std::span<const Point> points,
                                                   std::int32_t extent, TableMemory& memory);

}  // namespace sfumato::mesh
