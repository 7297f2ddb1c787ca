#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"
#include "curves/flatten.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// Returns the piece of a curve on which a segment that begins at the parameter lies.
Cubic piece_of(const Curve& curve, double parameter_of_start);

/// All segments of polylines, in a binary tree of the boxes of their stretches of curve.
class SegmentTree {
 public:
  /// Builds the tree from vertices on their curves; call it first. Boxes are grown by `reach`.
  /// Errors: limit, cancelled; no other function may then be called.
  Status build(Context& context, const FlatCurves& flat, std::span<const Curve> curves,
               double reach);

  /// Calls visit(segment) for the segments whose box, or a neighbour's box, meets(box). Visits at
  /// most `patience` boxes; returns whether these were enough.
  template <class Meets, class Visit>
  bool visit(const Meets& meets, int patience, const Visit& visit) const {
    std::uint32_t stack[2 * 32];
    int depth = 0;
    stack[depth++] = 1;
    while (depth > 0 && patience-- > 0) {
      const std::uint32_t node = stack[--depth];
      if (!meets(box_[node])) continue;
      if (node < first_leaf_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
        continue;
      }
      const std::size_t begin = std::size_t{node - first_leaf_} * kLeafSegments;
      const std::size_t end = std::min(begin + kLeafSegments, segment_.size());
      for (std::size_t i = begin; i < end; ++i) visit(segment_[i]);
    }
    return depth == 0;
  }

 private:
  static constexpr std::uint32_t kLeafSegments = 4;

  Status order_segments(Context& context, const FlatCurves& flat);

  std::vector<std::uint32_t> segment_;
  std::uint32_t leaf_count_ = 0;
  std::uint32_t first_leaf_ = 1;
  std::vector<Box> box_;  ///< of node n, whose children are 2 n and 2 n + 1
  TableMemory memory_{"flattening"};
};

}  // namespace sfumato::curves
