#pragma once

#include "gather/kernels/scene_layout.hpp"

namespace sfumato::gather {

SFUMATO_INLINE EndBox united(const EndBox& a, const EndBox& b) {
  return {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.x1 > b.x1 ? a.x1 : b.x1,
          a.y1 > b.y1 ? a.y1 : b.y1};
}

SFUMATO_INLINE bool overlap(const EndBox& a, const EndBox& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

/// Visits the leaves that the box meets, in the order of their ends, until `visit` returns false.
template <class Visit>
SFUMATO_INLINE void visit_leaves(const EndTree& tree, const EndBox& box, Visit visit) {
  if (tree.leaf_count == 0) return;
  std::uint32_t stack[34];  // a node of each level of a tree of 2³² leaves, and its sibling
  int size = 0;
  stack[size++] = 1;
  while (size > 0) {
    const std::uint32_t node = stack[--size];
    if (!overlap(tree.box[node], box)) continue;
    if (node < tree.leaf_count) {
      stack[size++] = 2 * node + 1;
      stack[size++] = 2 * node;
    } else if (!visit(node - tree.leaf_count)) {
      return;
    }
  }
}

}  // namespace sfumato::gather
