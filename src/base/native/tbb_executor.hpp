#pragma once

#include <memory>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// Makes a thread pool of oneTBB. thread_count 0: one thread per core that this process may use. If
/// the system refuses threads, the pool has fewer. Null where only the calling thread is left, and
/// where memory is exhausted.
std::unique_ptr<Executor> make_tbb_executor(int thread_count = 0);

}  // namespace sfumato
