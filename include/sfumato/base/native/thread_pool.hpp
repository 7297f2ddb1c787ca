#pragma once

#include <cstddef>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// An Executor with threads of its own, by oneTBB. It may serve several Contexts at once, and must
/// outlive the calls that use it.
class ThreadPool final : public Executor {
 public:
  /// Starts `thread_count` threads, the calling one included: at most limits::kThreads, and for 0
  /// or less one per core that this process may use. Where the system refuses threads the pool has
  /// fewer, and where memory is exhausted only the calling thread.
  explicit ThreadPool(int thread_count = 0);
  ~ThreadPool() override;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// As Executor::run: in the calling thread and in those of the pool that are free.
  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override;
  /// How many threads the pool has, the calling one included.
  int thread_count() const override;

 private:
  Executor* pool_;  ///< owned; null: the calling thread
};

}  // namespace sfumato
