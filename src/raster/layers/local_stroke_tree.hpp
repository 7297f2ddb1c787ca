#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::raster {

/// Finds the segments of a stroke whose reach meets a rectangle, in the order along the stroke. A
/// tree of boxes over runs of eight neighbours, since consecutive segments lie near one another.
class StrokeTree {
 public:
  StrokeTree() = default;

  /// Builds the tree. Errors: limit (memory). Cost: O(boxes).
  static Result<StrokeTree> create(Context& context, std::span<const Box> boxes);

  /// Calls found(indices) for runs of at most kBatch indices, ascending.
  void find(const Box& box, FunctionRef<void(std::span<const std::uint32_t>)> found) const;

  static constexpr std::size_t kBatch = 64;

 private:
  /// Single precision, rounded outwards.
  struct Bounds {
    float low[2];
    float high[2];
  };
  struct Search;

  void search(std::size_t level, std::size_t index, Search& search) const;

  std::vector<Bounds> bounds_;            ///< level by level, the boxes themselves first
  std::vector<std::size_t> level_begin_;  ///< into bounds_; the last level is one box
  TableMemory memory_{"a stroke"};
};

}  // namespace sfumato::raster
