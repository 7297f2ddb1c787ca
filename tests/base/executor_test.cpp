#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "base/stopwatch.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato {
namespace {

/// Only a failing test waits this long, because threads may start late on a busy machine.
constexpr double kMostSeconds = 60;

/// Returns whether `count` threads of an executor work at the same time.
bool works_with(Executor& executor, int count) {
  std::atomic<int> at_work{0};
  const Stopwatch watch;
  executor.run(static_cast<std::size_t>(count), [&](std::size_t) {
    ++at_work;
    while (at_work < count && watch.seconds() < kMostSeconds) std::this_thread::yield();
    if (at_work < count) at_work = -1000;
  });
  return at_work == count;
}

TEST(Executors, have_the_threads_that_were_asked_for) {
  ThreadPool executor(8);
  EXPECT_EQ(executor.thread_count(), 8);
  EXPECT_TRUE(works_with(executor, 8));
}

TEST(Executors, leave_each_other_their_threads) {
  ThreadPool two(2);
  ThreadPool five(5);
  EXPECT_TRUE(works_with(two, 2));
  EXPECT_TRUE(works_with(five, 5));
}

}  // namespace
}  // namespace sfumato
