#include "base/no_throw.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

#include "base/charge.hpp"
#include "base/parallel.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/native/thread_pool.hpp"

/// Exceptions of the allocator become a status. tests/allocation checks that every public function
/// does so for every allocation.
namespace sfumato {
namespace {

TEST(NoThrow, hands_on_what_the_body_returns) {
  EXPECT_TRUE(no_throw([] { return ok_status(); }).ok());
  const Result<int> number = no_throw([] { return Result<int>(7); });
  ASSERT_TRUE(number.ok());
  EXPECT_EQ(*number, 7);
}

TEST(NoThrow, failed_allocation_is_out_of_memory) {
  const Result<int> number = no_throw([]() -> Result<int> { throw std::bad_alloc(); });
  EXPECT_EQ(number.status().code, StatusCode::out_of_memory);
  EXPECT_EQ(to_string(number.status()), "out of memory");
}

TEST(NoThrow, more_elements_than_memory_can_hold_are_out_of_memory) {
  const Status status = no_throw([] {
    std::vector<double> values;
    values.reserve(values.max_size() + 1);
    return ok_status();
  });
  EXPECT_EQ(status.code, StatusCode::out_of_memory);
}

TEST(NoThrow, charges_of_the_body_are_given_back) {
  Context context;
  const Status status = no_throw([&]() -> Status {
    ScopedCharge charge;
    EXPECT_TRUE(charge.add(context, 100, "a test").ok());
    throw std::bad_alloc();
  });
  EXPECT_FALSE(status.ok());
  EXPECT_EQ(context.budget.used(), 0u);
}

void expect_parallel_for_runs_out_of_memory(Executor* executor) {
  Context context{.executor = executor};
  std::atomic<int> calls{0};
  const Status status = parallel_for(context, 1000, 1, [&](std::size_t begin, std::size_t) {
    ++calls;
    if (begin % 100 == 7) throw std::bad_alloc();
  });
  EXPECT_EQ(status.code, StatusCode::out_of_memory);
  EXPECT_LT(calls, 1000);  // the remaining calls are skipped
  EXPECT_TRUE(parallel_for(context, 1000, 1, [](std::size_t, std::size_t) {}).ok());
}

TEST(ParallelFor, failed_allocation_of_a_body_is_out_of_memory) {
  expect_parallel_for_runs_out_of_memory(nullptr);
}

TEST(ParallelFor, failed_allocation_on_another_thread_is_out_of_memory) {
  ThreadPool executor(4);
  expect_parallel_for_runs_out_of_memory(&executor);
}

/// Returns how many ranges were started.
int expect_the_failure_of_a_body(Executor* executor) {
  Context context{.executor = executor};
  std::atomic<int> done{0};
  const Status status = try_parallel_for(context, 1'000'000, 1, [&](std::size_t i, std::size_t) {
    ++done;
    return i == 7 ? make_error(StatusCode::io, "the eighth") : ok_status();
  });
  EXPECT_EQ(status.code, StatusCode::io);
  EXPECT_EQ(status.message, "the eighth");
  const auto fine = [](std::size_t, std::size_t) { return ok_status(); };
  EXPECT_TRUE(try_parallel_for(context, 1000, 1, fine).ok());
  return done;
}

TEST(ParallelFor, failure_of_a_body_is_the_status_and_ends_the_rest) {
  EXPECT_EQ(expect_the_failure_of_a_body(nullptr), 8);
}

TEST(ParallelFor, failure_of_a_body_on_another_thread_is_the_status) {
  ThreadPool executor(4);
  expect_the_failure_of_a_body(&executor);
}

TEST(ParallelFor, many_threads_do_every_item_once) {
  ThreadPool executor(8);
  Context context{.executor = &executor};
  std::vector<std::atomic<int>> done(10'000);
  const auto body = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++done[i];
  };
  ASSERT_TRUE(parallel_for(context, done.size(), 3, body).ok());
  for (const std::atomic<int>& count : done) ASSERT_EQ(count, 1);
}

TEST(ParallelFor, loops_may_stand_within_loops) {
  ThreadPool executor(4);
  Context context{.executor = &executor};
  std::atomic<int> done{0};
  const Status status = parallel_for(context, 50, 1, [&](std::size_t, std::size_t) {
    const Status inner = parallel_for(context, 50, 1, [&](std::size_t, std::size_t) { ++done; });
    EXPECT_TRUE(inner.ok());
  });
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(done, 2500);
}

}  // namespace
}  // namespace sfumato
