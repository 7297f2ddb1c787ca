#include "base/unset_allocator.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/table_memory.hpp"

namespace sfumato {
namespace {

struct Pair {
  int first;
  int second;
};

TEST(UnsetAllocator, keeps_items_while_a_table_grows_and_is_charged) {
  Context context;
  TableMemory memory("a test");
  std::vector<Pair, UnsetAllocator<Pair>> table;
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(memory.push_back(context, table, {i, -i}).ok());
  ASSERT_TRUE(memory.reserve(context, table, 5000).ok());
  table.resize(5000);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(table[static_cast<std::size_t>(i)].first, i);
    EXPECT_EQ(table[static_cast<std::size_t>(i)].second, -i);
  }
  EXPECT_EQ(context.budget.used(), 5000 * sizeof(Pair));
}

TEST(UnsetAllocator, constructs_items_that_are_not_trivial_or_have_a_value) {
  std::vector<std::string, UnsetAllocator<std::string>> texts;
  texts.resize(3);
  EXPECT_EQ(texts[2], "");
  std::vector<int, UnsetAllocator<int>> numbers;
  numbers.resize(4, 7);
  EXPECT_EQ(numbers[3], 7);
}

}  // namespace
}  // namespace sfumato
