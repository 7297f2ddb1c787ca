#include "base/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sfumato::test {
namespace {

std::vector<std::uint32_t> order_of(const std::vector<Vec2>& points) {
  const Context context;
  TableMemory memory("a test");
  std::vector<std::uint32_t> order;
  EXPECT_TRUE(spatial_order(context, points, memory, order).ok());
  return order;
}

TEST(SpatialOrder, every_point_stands_once) {
  std::mt19937 random(1);
  for (std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
    std::vector<Vec2> points(count);
    for (Vec2& p : points) p = {random() * 1e-3, random() * 1e-6};
    std::vector<std::uint32_t> order = order_of(points);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), count);
    for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(order[i], i);
  }
}

TEST(SpatialOrder, neighbours_in_the_list_are_near_each_other) {
  std::mt19937 random(2);
  std::vector<Vec2> points(4096);
  for (Vec2& p : points) p = {random() / 4294967296.0, random() / 4294967296.0};
  const std::vector<std::uint32_t> order = order_of(points);
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    sum += length(points[order[i]] - points[order[i - 1]]);
  }
  // Two random points of the square are 0.52 apart on average.
  EXPECT_LT(sum / 4095, 0.05);
}

TEST(SpatialOrder, points_in_one_place_keep_their_order) {
  const std::vector<Vec2> points(5, Vec2{3, 4});
  EXPECT_EQ(order_of(points), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace sfumato::test
