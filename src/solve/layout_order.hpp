#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/table_memory.hpp"
#include "sfumato/base/context.hpp"
#include "solve/nodes.hpp"

namespace sfumato::solve {

/// Numbers the nodes of an updated layout as lay_out_nodes would, and drops those that no triangle
/// uses. Returns the old number of each node. Other per-node data must be put in the same order
/// (`reorder`).
/// memory   the layout's memory, from which the list is allocated too
/// Errors   limit (memory), cancelled; the layout is unusable then
/// Cost     O(triangles)
Result<std::vector<std::uint32_t>> put_in_order(const Context& context,
                                                const mesh::TriangleMesh& mesh, TableMemory& memory,
                                                NodeLayout& layout);

/// Moves values[order[i]] to place i; a value is `width` items, allocated from `memory`. Errors:
/// limit (memory), cancelled; `values` is unchanged then.
template <class Item>
Status reorder(const Context& context, const std::vector<std::uint32_t>& order, TableMemory& memory,
               std::vector<Item>& values, std::size_t width = 1) {
  std::vector<Item> moved;
  Status status = memory.resize(context, moved, width * order.size());
  if (!status) return status;
  constexpr std::size_t kValuesPerTask = 16384;
  status = parallel_for(context, order.size(), kValuesPerTask, [&](auto begin, auto end) {
    if (width == 1) {
      for (std::size_t i = begin; i < end; ++i) moved[i] = values[order[i]];
    } else {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t k = 0; k < width; ++k) moved[width * i + k] = values[width * order[i] + k];
    }
  });
  if (!status) return status;
  values.swap(moved);
  memory.free(moved);
  return status;
}

}  // namespace sfumato::solve
