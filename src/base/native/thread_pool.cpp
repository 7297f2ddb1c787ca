#include "sfumato/base/native/thread_pool.hpp"

#include "base/native/tbb_executor.hpp"

namespace sfumato {

ThreadPool::ThreadPool(int thread_count) : pool_(make_tbb_executor(thread_count).release()) {}

ThreadPool::~ThreadPool() {
  delete pool_;
}

void ThreadPool::run(std::size_t task_count, FunctionRef<void(std::size_t)> task) {
  if (pool_) return pool_->run(task_count, task);
  Executor::run(task_count, task);
}

int ThreadPool::thread_count() const {
  return pool_ ? pool_->thread_count() : 1;
}

}  // namespace sfumato
