#include "curves/stop_parameters.hpp"

#include <gtest/gtest.h>

namespace sfumato::curves {
namespace {

/// Returns a chain of straight pieces, each of length 3.
std::vector<Vec2> staircase(std::size_t piece_count) {
  std::vector<Vec2> points{{0, 0}};
  for (std::size_t i = 0; i < piece_count; ++i) {
    const Vec2 step = i % 2 == 0 ? Vec2{1, 0} : Vec2{0, 1};
    for (int k = 0; k < 3; ++k) points.push_back(points.back() + step);
  }
  return points;
}

TEST(CumulativeLength, with_a_memory_is_that_without) {
  Context context;
  TableMemory memory("a test");
  const std::vector<Vec2> points = staircase(100);
  const auto lengths = cumulative_length(context, points, memory);
  ASSERT_TRUE(lengths.ok());
  EXPECT_EQ(*lengths, cumulative_length(points));
  EXPECT_EQ(lengths->size(), 101u);
  EXPECT_DOUBLE_EQ(lengths->back(), 300);
}

TEST(CumulativeLength, that_is_cancelled_is_no_shorter_table_but_a_status) {
  Context context;
  context.cancel = true;
  TableMemory memory("a test");
  const auto lengths = cumulative_length(context, staircase(100), memory);
  EXPECT_EQ(lengths.status().code, StatusCode::cancelled);
}

TEST(CumulativeLength, takes_its_room_from_the_budget) {
  const std::vector<Vec2> points = staircase(100);
  const auto code_with = [&](std::size_t bytes) {
    Context context{.budget = Budget(bytes)};
    TableMemory memory("a test");
    return cumulative_length(context, points, memory).status().code;
  };
  EXPECT_EQ(code_with(101 * sizeof(double)), StatusCode::ok);
  EXPECT_EQ(code_with(101 * sizeof(double) - 1), StatusCode::limit);
}

}  // namespace
}  // namespace sfumato::curves
