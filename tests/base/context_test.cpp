#include "sfumato/base/context.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "base/charge.hpp"
#include "base/limit_error.hpp"
#include "base/parallel.hpp"
#include "base/poll.hpp"

namespace sfumato::test {
namespace {

TEST(Limits, every_limit_has_one_name_and_can_be_lowered) {
  std::set<std::string_view> names;
  for (const LimitName& known : limit_names()) {
    EXPECT_TRUE(names.insert(known.name).second) << known.name;
    EXPECT_GE(known.highest, Limits{}.*(known.value)) << known.name;
    Limits changed;
    changed.*(known.value) = 12345;
    const Status status = limit_error(changed, known.value, "things");
    EXPECT_EQ(status.message, "more than the limit of 12345 things");
    EXPECT_EQ(status.limit, known.name);
  }
}

TEST(Deadline, none_is_set_by_itself) {
  const Context context;
  EXPECT_FALSE(context.cancelled());
  EXPECT_TRUE(context.check().ok());
}

TEST(Deadline, passing_it_is_the_limit_called_time) {
  const Context late{.deadline = Deadline::in(0)};
  EXPECT_TRUE(late.cancelled());
  EXPECT_EQ(late.check().code, StatusCode::limit);
  const Context in_time{.deadline = Deadline::in(1e9)};
  EXPECT_TRUE(in_time.check().ok());
  Deadline over = Deadline::in(0);
  over.seconds = 2.5;
  const Context named{.deadline = over};
  EXPECT_EQ(named.check().message, "the time limit of 2.5 s is over");
  EXPECT_EQ(named.check().limit, "time");
}

TEST(Limits, none_can_be_raised_beyond_what_tables_are_made_for) {
  for (const LimitName& known : limit_names()) {
    Context context;
    context.limits.*(known.value) = known.highest;
    EXPECT_TRUE(validate(context).ok()) << known.name;
    context.limits.*(known.value) = known.highest + 1;
    const Status status = validate(context);
    EXPECT_EQ(status.code, StatusCode::bad_input) << known.name;
    EXPECT_NE(status.message.find(known.name), std::string::npos) << status.message;
  }
}

TEST(Context, one_that_cannot_be_worked_in_is_refused) {
  EXPECT_EQ(validate(Context{.simd = SimdLevel(200)}).code, StatusCode::bad_input);
  EXPECT_EQ(validate(Context{.deadline = Deadline::in(NAN)}).code, StatusCode::bad_input);
  Context round;
  round.outer = &round;
  EXPECT_EQ(validate(round).code, StatusCode::bad_input);
}

TEST(Deadline, any_number_of_seconds_is_a_time) {
  for (const double seconds : {1e10, 1e300, HUGE_VAL}) {
    EXPECT_TRUE(Context{.deadline = Deadline::in(seconds)}.check().ok()) << seconds;
  }
  for (const double seconds : {-1.0, -1e10, -1e300, -HUGE_VAL}) {
    EXPECT_EQ(Context{.deadline = Deadline::in(seconds)}.check().code, StatusCode::limit)
        << seconds;
  }
}

TEST(ScopedCharge, belongs_to_one_budget) {
  Context first, second;
  {
    ScopedCharge charge;
    ASSERT_TRUE(charge.add(first, 100, "a test").ok());
    ASSERT_TRUE(charge.add(second, 50, "a test").ok());
    EXPECT_EQ(first.budget.used(), 150u);
    EXPECT_EQ(second.budget.used(), 0u);
  }
  EXPECT_EQ(first.budget.used(), 0u);
  EXPECT_EQ(second.budget.used(), 0u);
}

TEST(Budget, gives_back_no_more_than_was_taken) {
  Budget budget(1000);
  ASSERT_TRUE(budget.charge(10, "a test").ok());
  budget.release(11);
  EXPECT_EQ(budget.used(), 0u);
  EXPECT_TRUE(budget.charge(1000, "a test").ok());
}

TEST(Result, without_value_or_error_is_internal) {
#ifdef NDEBUG
  const Result<int> nothing(ok_status());
  EXPECT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.status().code, StatusCode::internal);
#else
  EXPECT_DEATH(static_cast<void>(Result<int>{ok_status()}), "status");
#endif
}

TEST(Deadline, the_flag_goes_before_it) {
  Context context{.deadline = Deadline::in(0)};
  context.cancel = true;
  EXPECT_EQ(context.check().code, StatusCode::cancelled);
}

TEST(Deadline, loops_end_at_it) {
  Context context;
  std::size_t done = 0;
  const Status status = parallel_for(context, 1'000'000'000, 1, [&](std::size_t, std::size_t) {
    if (done++ == 0) context.deadline = Deadline::in(0.02);
  });
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_GT(done, 0u);
  EXPECT_LT(done, 1'000'000'000u);
}

TEST(Poll, a_rare_poll_looks_once_in_its_turns) {
  struct Counter : PollWatch {
    void polled() override { ++count; }
    int count = 0;
  } counter;
  const Context context{.poll_watch = &counter};
  RarePoll<8> poll(context);
  for (int i = 0; i < 80; ++i) EXPECT_FALSE(poll.cancelled());
  EXPECT_EQ(counter.count, 10);
}

TEST(Budget, charges_end_with_their_scope) {
  Context context{.budget = Budget(100)};
  {
    ScopedCharge charge;
    EXPECT_TRUE(charge.add(context, 60, "a").ok());
    EXPECT_EQ(charge.add(context, 60, "b").code, StatusCode::limit);
    EXPECT_TRUE(charge.add(context, 40, "c").ok());
    EXPECT_EQ(context.budget.used(), 100u);
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::test
