// Replaces tbb_executor.cpp under ThreadSanitizer, which cannot see how the installed oneTBB, built
// without instrumentation, orders its own memory. Starts plain threads for every call.

#include <oneapi/tbb/info.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/native/tbb_executor.hpp"

namespace sfumato {
namespace {

class ThreadExecutor final : public Executor {
 public:
  explicit ThreadExecutor(int thread_count) : thread_count_(thread_count) {}

  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override {
    std::atomic<std::size_t> next{0};
    std::mutex failure_mutex;
    std::exception_ptr failure;
    const auto work = [&] {
      try {
        for (std::size_t i = next++; i < task_count; i = next++) task(i);
      } catch (...) {
        const std::scoped_lock lock(failure_mutex);
        failure = std::current_exception();
      }
    };
    std::vector<std::jthread> others;
    const std::size_t useful = std::min(static_cast<std::size_t>(thread_count_), task_count);
    for (std::size_t i = 1; i < useful; ++i) others.emplace_back(work);
    work();
    others.clear();
    if (failure) std::rethrow_exception(failure);
  }

  int thread_count() const override { return thread_count_; }

 private:
  int thread_count_;
};

}  // namespace

std::unique_ptr<Executor> make_tbb_executor(int thread_count) {
  if (thread_count <= 0) thread_count = tbb::info::default_concurrency();
  return std::make_unique<ThreadExecutor>(thread_count);
}

}  // namespace sfumato
