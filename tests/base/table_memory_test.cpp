#include "base/table_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sfumato::test {
namespace {

/// Returns numbers in a jumping order, each once; 2^17 + 1 of them make runs of different lengths.
std::vector<std::uint32_t> shuffled_numbers() {
  constexpr std::uint32_t kCount = (1u << 17) + 1;
  std::vector<std::uint32_t> numbers(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    numbers[i] = static_cast<std::uint32_t>(std::uint64_t{40'507} * i % kCount);
  }
  return numbers;
}

TEST(TableMemory, charges_what_is_allocated) {
  Context context;
  {
    TableMemory memory("a test");
    std::vector<double> numbers;
    std::vector<std::uint8_t> marks;
    ASSERT_TRUE(memory.resize(context, numbers, 1000, 2.5).ok());
    ASSERT_TRUE(memory.resize(context, marks, 77).ok());
    EXPECT_EQ(numbers, std::vector<double>(1000, 2.5));
    EXPECT_EQ(context.budget.used(), capacity_bytes(numbers, marks));
    for (int i = 0; i < 5000; ++i) {
      ASSERT_TRUE(memory.make_room(context, numbers).ok());
      const std::size_t before = numbers.capacity();
      numbers.push_back(i);
      ASSERT_EQ(numbers.capacity(), before);
      ASSERT_EQ(context.budget.used(), capacity_bytes(numbers, marks));
    }
    EXPECT_EQ(numbers.back(), 4999);
    EXPECT_EQ(numbers[999], 2.5);
    memory.free(numbers);
    EXPECT_EQ(numbers.capacity(), 0u);
    EXPECT_EQ(context.budget.used(), capacity_bytes(marks));
  }
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(TableMemory, moves_with_its_tables) {
  Context context;
  std::vector<int> kept;
  TableMemory memory("a test");
  {
    TableMemory inner("another test");
    ASSERT_TRUE(inner.resize(context, kept, 300).ok());
    memory.take(std::move(inner));
  }
  EXPECT_EQ(context.budget.used(), capacity_bytes(kept));
  const TableMemory moved = std::move(memory);
  EXPECT_EQ(context.budget.used(), capacity_bytes(kept));
}

TEST(TableMemory, refuses_before_it_allocates) {
  Context context{.budget = Budget(10'000)};
  TableMemory memory("a test");
  std::vector<std::uint64_t> numbers;
  ASSERT_TRUE(memory.resize(context, numbers, 600, 7).ok());
  const Status status =
      memory.resize(context, numbers, 700);  // in addition to the 600 while they move
  EXPECT_EQ(status.code, StatusCode::limit);
  EXPECT_NE(status.message.find("a test"), std::string::npos) << status.message;
  EXPECT_EQ(numbers, std::vector<std::uint64_t>(600, 7));
  EXPECT_EQ(context.budget.used(), capacity_bytes(numbers));
  EXPECT_EQ(memory.reserve(context, numbers, std::numeric_limits<std::size_t>::max()).code,
            StatusCode::limit);
}

TEST(TableMemory, ends_when_cancelled) {
  Context context;
  context.cancel = true;
  TableMemory memory("a test");
  std::vector<std::uint32_t> numbers;
  EXPECT_EQ(memory.resize(context, numbers, 10).code, StatusCode::cancelled);
  EXPECT_TRUE(memory.resize(context, numbers, 0).ok());
  std::vector<std::uint32_t> filled = shuffled_numbers();
  const std::size_t used = context.budget.used();
  EXPECT_EQ(memory.reserve(context, filled, 2 * filled.size()).code, StatusCode::cancelled);
  EXPECT_EQ(context.budget.used(), used);
}

TEST(TableMemory, keeps_items_that_only_move) {
  Context context;
  TableMemory memory("a test");
  std::vector<std::unique_ptr<int>> items;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(memory.push_back(context, items, std::make_unique<int>(i)).ok());
  }
  for (int i = 0; i < 100; ++i) EXPECT_EQ(*items[static_cast<std::size_t>(i)], i);
}

TEST(TableMemory, appends) {
  Context context;
  TableMemory memory("a test");
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(memory.append(context, "curves", bytes).ok());
  ASSERT_TRUE(memory.append(context, std::vector<std::uint8_t>{1, 2}, bytes).ok());
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "curves\1\2");
  std::string text = "diffusion ";
  const std::string more(1 << 20, 'x');
  ASSERT_TRUE(memory.append(context, std::span<const char>(more), text).ok());
  EXPECT_EQ(text, "diffusion " + more);
  EXPECT_EQ(context.budget.used(), capacity_bytes(bytes, text));
  memory.free(text);
  EXPECT_EQ(context.budget.used(), capacity_bytes(bytes));
}

TEST(TableMemory, sorts_and_gives_the_charge_back) {
  std::vector<std::uint32_t> numbers = shuffled_numbers(), expected = numbers;
  std::sort(expected.begin(), expected.end());
  ASSERT_NE(numbers, expected);
  Context context;
  EXPECT_TRUE(TableMemory::sort(context, numbers, std::less<>()).ok());
  EXPECT_EQ(numbers, expected);
  EXPECT_EQ(context.budget.used(), 0u);
}

TEST(TableMemory, sorting_is_charged_and_ends_when_cancelled) {
  std::vector<std::uint32_t> numbers = shuffled_numbers();
  Context poor{.budget = Budget(1000)};
  EXPECT_EQ(TableMemory::sort(poor, numbers, std::less<>()).code, StatusCode::limit);
  Context context;
  context.cancel = true;
  EXPECT_EQ(TableMemory::sort(context, numbers, std::less<>()).code, StatusCode::cancelled);
}

TEST(ScopedCharge, holds_nothing_once_it_has_moved) {
  Context first, second;
  ScopedCharge charge;
  ASSERT_TRUE(charge.add(first, 100, "a test").ok());
  {
    const ScopedCharge moved = std::move(charge);
    ASSERT_TRUE(charge.add(second, 30, "a test").ok());
    charge.release(1000);
    EXPECT_EQ(second.budget.used(), 0u);
    EXPECT_EQ(first.budget.used(), 100u);
    ASSERT_TRUE(charge.raise_to(second, 40, "a test").ok());
    EXPECT_EQ(second.budget.used(), 40u);
  }
  EXPECT_EQ(first.budget.used(), 0u);
}

TEST(ScopedCharge, is_raised_and_released_but_not_below_zero) {
  Context context;
  ScopedCharge charge;
  charge.release(5);
  ASSERT_TRUE(charge.raise_to(context, 100, "a test").ok());
  ASSERT_TRUE(charge.raise_to(context, 60, "a test").ok());
  EXPECT_EQ(context.budget.used(), 100u);
  ASSERT_TRUE(charge.raise_to(context, 130, "a test").ok());
  EXPECT_EQ(context.budget.used(), 130u);
  charge.release(1000);
  EXPECT_EQ(context.budget.used(), 0u);
}

}  // namespace
}  // namespace sfumato::test
