#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/no_throw.hpp"
#include "base/try.hpp"

namespace sfumato {
Status try_parallel_for(const Context& context, std::size_t count, std::size_t grain,
                        FunctionRef<Status(std::size_t, std::size_t)> body) {
  const std::size_t task_count = (count + grain - 1) / grain;
  Status failure;
  std::atomic<bool> has_failed{false};
  std::atomic<bool> goes_on{true};  // faster to read than the clock, where many ranges are left
  const auto task = [&](std::size_t i) {
    if (!goes_on.load(std::memory_order_relaxed)) return;
    if (context.cancelled()) {
      goes_on.store(false, std::memory_order_relaxed);
      return;
    }
    // The body must not throw into an executor: a thread pool without memory cannot pass an
    // exception on.
    Status status = no_throw([&] { return body(i * grain, std::min(count, (i + 1) * grain)); });
    if (status) return;
    if (!has_failed.exchange(true)) failure = std::move(status);
    goes_on.store(false, std::memory_order_relaxed);
  };
  if (context.executor && task_count > 1) {
    context.executor->run(task_count, task);
  } else {
    for (std::size_t i = 0; i < task_count && goes_on; ++i) task(i);
  }
  if (context.cancelled()) return context.cancel_status();
  return failure;
}

Status parallel_for(const Context& context, std::size_t count, std::size_t grain,
                    FunctionRef<void(std::size_t, std::size_t)> body) {
  return try_parallel_for(context, count, grain, [&](std::size_t begin, std::size_t end) {
    body(begin, end);
    return ok_status();
  });
}

Status run_both(const Context& context, FunctionRef<Status()> first, FunctionRef<Status()> second) {
  Status outcome[2];
  SFUMATO_TRY(parallel_for(context, 2, 1, [&](std::size_t i, std::size_t) {
    outcome[i] = no_throw([&] { return i == 0 ? first() : second(); });
  }));
  return outcome[0] ? outcome[1] : outcome[0];
}

}  // namespace sfumato
