#include "base/half_edge.hpp"

#include <gtest/gtest.h>

namespace sfumato {
namespace {

TEST(HalfEdge, next_goes_round_its_triangle) {
  EXPECT_EQ(next_half_edge(0), 1u);
  EXPECT_EQ(next_half_edge(1), 2u);
  EXPECT_EQ(next_half_edge(2), 0u);
  EXPECT_EQ(next_half_edge(3 * 7 + 2), 3 * 7u);
}

TEST(HalfEdge, previous_is_what_next_came_from) {
  for (std::uint32_t h = 0; h < 300; ++h) {
    EXPECT_EQ(previous_half_edge(next_half_edge(h)), h);
    EXPECT_EQ(next_half_edge(next_half_edge(h)), previous_half_edge(h));
    EXPECT_EQ(next_half_edge(h) / 3, h / 3);
  }
}

}  // namespace
}  // namespace sfumato
