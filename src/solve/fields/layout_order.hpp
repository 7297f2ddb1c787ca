#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "base/table_memory.hpp"
#include "base/try.hpp"
#include "sfumato/base/context.hpp"
#include "solve/fields/nodes.hpp"

namespace sfumato::solve {

/// Numbers the nodes of an updated layout as lay_out_nodes would, and drops the nodes that no
/// triangle uses. Returns the old number of each node. Other per-node data must be put in the same
/// order (`reorder`).
///
/// memory   the layout's memory; the list is allocated from it, too
/// Errors   limit (memory), cancelled; the layout is then unusable
/// Cost     O(triangles)
Result<std::vector<std::uint32_t>> put_in_order(const Context& context,
                                                const mesh::TriangleMesh& mesh, TableMemory& memory,
                                                NodeLayout& layout);

/// Moves values[order[i]] to place i; a value is `width` items, allocated from `memory`. Errors:
/// limit (memory), cancelled; `values` is then unchanged.
template <class Item>
Status reorder(const Context& context, const std::vector<std::uint32_t>& order, TableMemory& memory,
               std::vector<Item>& values, std::size_t width = 1) {
  std::vector<Item> moved;
  SFUMATO_TRY(memory.resize(context, moved, width * order.size()));
  constexpr std::size_t kValuesPerTask = 16384;
  SFUMATO_TRY(parallel_for(context, order.size(), kValuesPerTask, [&](auto begin, auto end) {
    if (width == 1) {
      for (std::size_t i = begin; i < end; ++i) moved[i] = values[order[i]];
    } else {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t k = 0; k < width; ++k) moved[width * i + k] = values[width * order[i] + k];
    }
  }));
  values.swap(moved);
  memory.free(moved);
  return ok_status();
}

}  // namespace sfumato::solve
