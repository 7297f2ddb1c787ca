#include "base/context.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace sfumato::test {
namespace {

TEST(Limits, every_limit_has_one_name_and_can_be_lowered) {
  std::set<std::string_view> names;
  for (const LimitName& known : limit_names()) {
    EXPECT_TRUE(names.insert(known.name).second) << known.name;
    EXPECT_GE(known.highest, Limits{}.*(known.value)) << known.name;
    Limits changed;
    changed.*(known.value) = 12345;
    EXPECT_EQ(limit_text(changed, known.value, "things"),
              "12345 things (--limit " + std::string(known.name) + "=N sets another)");
  }
}

TEST(Deadline, none_is_set_by_itself) {
  const Context context;
  EXPECT_FALSE(context.cancelled());
  EXPECT_TRUE(context.check().ok());
}

TEST(Deadline, passing_it_is_a_limit_that_names_the_option) {
  const Context late{.deadline = Deadline::in(0)};
  EXPECT_TRUE(late.cancelled());
  EXPECT_EQ(late.check().code, StatusCode::limit);
  const Context in_time{.deadline = Deadline::in(1e9)};
  EXPECT_TRUE(in_time.check().ok());
  Deadline over = Deadline::in(0);
  over.seconds = 2.5;
  const Context named{.deadline = over};
  EXPECT_EQ(named.check().message, "the time limit of 2.5 s is over (--max-time sets another)");
}

TEST(Deadline, the_flag_goes_before_it) {
  Context context{.deadline = Deadline::in(0)};
  context.cancel = true;
  EXPECT_EQ(context.check().code, StatusCode::cancelled);
}

TEST(Deadline, loops_end_at_it) {
  Context context{.deadline = Deadline::in(0.02)};
  std::size_t done = 0;
  const Status status =
      parallel_for(context, 1'000'000'000, 1, [&](std::size_t, std::size_t) { ++done; });
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
