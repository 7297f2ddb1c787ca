#include "base/native/tbb_executor.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace sfumato {
namespace {

class TbbExecutor final : public Executor {
 public:
  // The control lets an arena have more threads than cores: tests ask for 8 on 2 cores.
  explicit TbbExecutor(int thread_count)
      : parallelism_(tbb::global_control::max_allowed_parallelism,
                     static_cast<std::size_t>(thread_count)),
        arena_(thread_count) {}

  void run(std::size_t task_count, FunctionRef<void(std::size_t)> task) override {
    arena_.execute([&] {
      tbb::parallel_for(
          std::size_t{0}, task_count, [&](std::size_t i) { task(i); }, tbb::auto_partitioner{});
    });
  }

  int thread_count() const override { return arena_.max_concurrency(); }

 private:
  tbb::global_control parallelism_;
  tbb::task_arena arena_;
};

}  // namespace

std::unique_ptr<Executor> make_tbb_executor(int thread_count) {
  if (thread_count <= 0) thread_count = tbb::info::default_concurrency();
  return std::make_unique<TbbExecutor>(thread_count);
}

}  // namespace sfumato
