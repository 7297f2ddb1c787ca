#pragma once

#include <memory>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// A thread pool of oneTBB. thread_count 0: one thread per core that this process may use. Where
/// the system refuses threads the pool has fewer; where memory is out there is none: null, which is
/// a Context's calling thread alone.
std::unique_ptr<Executor> make_tbb_executor(int thread_count = 0);

}  // namespace sfumato
