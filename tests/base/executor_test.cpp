#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "base/native/tbb_executor.hpp"
#include "base/stopwatch.hpp"

namespace sfumato {
namespace {

/// Whether `count` threads of an executor are at work at the same time.
bool works_with(Executor& executor, int count) {
  std::atomic<int> at_work{0};
  const Stopwatch watch;
  executor.run(static_cast<std::size_t>(count), [&](std::size_t) {
    ++at_work;
    while (at_work < count && watch.seconds() < 5) std::this_thread::yield();
    if (at_work < count) at_work = -1000;
  });
  return at_work == count;
}

TEST(Executors, have_the_threads_that_were_asked_for) {
  const std::unique_ptr<Executor> executor = make_tbb_executor(8);
  EXPECT_EQ(executor->thread_count(), 8);
  EXPECT_TRUE(works_with(*executor, 8));
}

TEST(Executors, leave_each_other_their_threads) {
  const std::unique_ptr<Executor> two = make_tbb_executor(2);
  const std::unique_ptr<Executor> five = make_tbb_executor(5);
  EXPECT_TRUE(works_with(*two, 2));
  EXPECT_TRUE(works_with(*five, 5));
}

}  // namespace
}  // namespace sfumato
