#pragma once

#include <cstddef>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// An Executor with threads of its own, by oneTBB. Where the system refuses threads the pool has
/// fewer; where memory is out it has the calling thread alone.
class ThreadPool final : public Executor {
 public:
  /// thread_count    0: one thread per core that this process may use; at most limits::kThreads
  explicit ThreadPool(int thread_count = 0);
  ~ThreadPool() override;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override;
  int thread_count() const override;

 private:
  Executor* pool_;  ///< owned; null: the calling thread
};

}  // namespace sfumato
