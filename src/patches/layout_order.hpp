#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/large_vector.hpp"
#include "patches/nodes.hpp"

namespace sfumato::patches {

/// Numbers the nodes of an updated layout as lay_out_nodes would, and drops those that no triangle
/// has. Returns per node of now the number that it had. What else is kept for each node is to be
/// `reordered` too.
/// Errors  cancelled; the layout is good for nothing then
/// Cost    O(triangles)
Result<std::vector<std::uint32_t>> put_in_order(const Context& context,
                                                const mesh::TriangleMesh& mesh, NodeLayout& layout);

/// values[i] for each i of `order`; a value is `width` items. Incomplete where the context is
/// cancelled.
template <class Item>
std::vector<Item> reordered(const Context& context, const std::vector<std::uint32_t>& order,
                            const std::vector<Item>& values, std::size_t width = 1) {
  std::vector<Item> moved;
  if (!resize_large(context, moved, width * order.size())) return moved;
  RarePoll<65536> poll(context);
  Item* to = moved.data();
  for (const std::uint32_t i : order) {
    if (poll.cancelled()) break;
    for (const Item* from = values.data() + width * i; from != values.data() + width * (i + 1);)
      *to++ = *from++;
  }
  return moved;
}

}  // namespace sfumato::patches
