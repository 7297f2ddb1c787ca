#pragma once

#include <cstddef>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato {

/// Calls body(begin, end) for consecutive ranges of [0, count) of `grain` items (the last may be
/// shorter). The cut does not depend on the number of threads; a body writes only its own slots.
/// After cancellation remaining ranges are skipped and the status is cancelled; so they are where
/// an allocation of a body fails, which is out_of_memory.
Status parallel_for(const Context& context, std::size_t count, std::size_t grain,
                    FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// parallel_for() of a body that may fail: after a failure remaining ranges are skipped, and it is
/// the status. Where several ranges fail, which of them that is depends on the threads.
Status try_parallel_for(const Context& context, std::size_t count, std::size_t grain,
                        FunctionRef<Status(std::size_t begin, std::size_t end)> body);

}  // namespace sfumato
