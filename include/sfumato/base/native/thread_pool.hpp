#pragma once

#include <cstddef>

#include "sfumato/base/context.hpp"

namespace sfumato {

/// An Executor with its own threads, by oneTBB. It may serve several Contexts at once, and must
/// outlive the calls that use it.
class ThreadPool final : public Executor {
 public:
  /// Starts `thread_count` threads, including the calling one: at most limits::kThreads, and for 0
  /// or less one per core that this process may use. The pool has fewer threads where the system
  /// refuses them, and only the calling thread where memory is exhausted.
  explicit ThreadPool(int thread_count = 0);
  ~ThreadPool() override;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Does Executor::run in the calling thread and in the free threads of the pool.
  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override;
  /// Returns the number of the pool's threads, including the calling one.
  int thread_count() const override;

 private:
  Executor* pool_;  ///< owned; null: the calling thread
};

}  // namespace sfumato
