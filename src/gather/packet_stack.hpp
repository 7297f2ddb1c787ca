#pragma once

#include <cstddef>
#include <vector>

#include "base/limit_error.hpp"
#include "base/table_memory.hpp"
#include "gather/kernels/scene_layout.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::gather {

/// Windows that wait during a walk: a few dozen on drawings, hundreds among thousands of short
/// curves, and as many as the triangles that a ray crosses on adversarial input.
class GrowingStack {
 public:
  explicit GrowingStack(const Context& context) : context_(context) {}

  PacketStack view() {
    if (!heap_.empty()) return {heap_.data(), static_cast<int>(heap_.size())};
    return {own_, kPacketStackLeast};
  }

  /// Grows the stack. The size that it reaches depends on the threads, so the error does not
  /// contain it. Errors: limit (memory), cancelled.
  Status grow() {
    const std::size_t capacity = 4 * static_cast<std::size_t>(view().capacity);
    memory_.free(heap_);
    const Status status = memory_.resize(context_, heap_, capacity);
    if (status || status.limit != "memory") return status;
    return make_limit_error("memory",
                            "memory limit reached: the gather's stack on this mesh needs more");
  }

 private:
  const Context& context_;
  StackSlot own_[kPacketStackLeast];
  std::vector<StackSlot> heap_;
  TableMemory memory_{"the gather's stack"};
};

}  // namespace sfumato::gather
