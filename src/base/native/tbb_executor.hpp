#pragma once

#include <memory>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// A thread pool of oneTBB. thread_count 0: one thread per core that this process may use. If the
/// system refuses threads, the pool has fewer. Null where that leaves the calling thread alone, and
/// where memory is exhausted.
std::unique_ptr<Executor> make_tbb_executor(int thread_count = 0);

}  // namespace sfumato
