#pragma once

#include <cstddef>

#include "sfumato/base/context.hpp"
#include "sfumato/base/function_ref.hpp"

namespace sfumato {

/// Calls body(begin, end) for consecutive ranges of [0, count) of `grain` items (the last may be
/// shorter). The cut does not depend on the number of threads; a body writes only its own slots.
/// After cancellation the remaining ranges are skipped and the status is cancelled. If an
/// allocation in a body fails, the remaining ranges are skipped and the status is out_of_memory.
Status parallel_for(const Context& context, std::size_t count, std::size_t grain,
                    FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// Does parallel_for() with a body that may fail. After a failure the remaining ranges are skipped,
/// and its status is returned. If several ranges fail, which status is returned depends on the
/// threads.
Status try_parallel_for(const Context& context, std::size_t count, std::size_t grain,
                        FunctionRef<Status(std::size_t begin, std::size_t end)> body);

/// Calls both functions, at the same time if there are two threads. Either runs to its end even if
/// the other fails. Returns the failure of the first, else that of the second; a failed allocation
/// is out_of_memory.
Status run_both(const Context& context, FunctionRef<Status()> first, FunctionRef<Status()> second);

}  // namespace sfumato
