#include "gather/scene/packing.hpp"

#include <gtest/gtest.h>

#include "gather/scenes.hpp"
#include "sfumato/base/native/thread_pool.hpp"

namespace sfumato::gather::test {
namespace {

class Packed : public testing::Test {
 protected:
  void SetUp() override {
    Result<Scene> scene = build_scene(context_, drawing_.mesh, drawing_.attributes);
    ASSERT_TRUE(scene.ok());
    scene_ = std::move(*scene);
  }

  LocatedPoints locate(Context& context) {
    const Result<Locator> locator = Locator::create(context, scene_);
    Result<LocatedPoints> located = locator->locate(context, points_);
    EXPECT_TRUE(located.ok());
    return std::move(*located);
  }

  Context context_;
  const Drawing drawing_ = draw(random_lines(80, 200, 0.2, 0.2));
  const std::vector<Vec2> points_ = random_points(drawing_, 80, 4000, 0);
  Scene scene_;
};

TEST_F(Packed, points_lie_in_the_triangles_they_are_located_in) {
  const LocatedPoints located = locate(context_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const SceneTriangle& t = scene_.triangle[located.triangle[i]];
    for (int k = 0; k < 3; ++k) {
      const int n = (k + 1) % 3;
      const Vec2 edge{double{t.x[n]} - t.x[k], double{t.y[n]} - t.y[k]};
      const Vec2 to_point{double{located.x[i]} - t.x[k], double{located.y[i]} - t.y[k]};
      EXPECT_GE(cross(edge, to_point), 0) << i;
    }
  }
}

TEST_F(Packed, location_does_not_depend_on_the_number_of_threads) {
  const LocatedPoints expected = locate(context_);
  ThreadPool executor(3);
  Context context;
  context.executor = &executor;
  EXPECT_EQ(locate(context).triangle, expected.triangle);
}

TEST_F(Packed, every_point_is_in_one_packet_in_its_own_triangle) {
  const LocatedPoints located = locate(context_);
  const Result<Packing> packing = pack(context_, scene_, located);
  ASSERT_TRUE(packing.ok());
  std::vector<int> seen(points_.size(), 0);
  for (const Packet& packet : packing->packet) {
    ASSERT_LE(packet.triangle_count, kPacketTriangles);
    int lane = 0;
    for (std::uint32_t i = 0; i < packet.triangle_count; ++i) {
      const PacketTriangle& t = packing->triangle[packet.first_triangle + i];
      EXPECT_EQ(t.lane_begin, lane);
      for (; lane < t.lane_end; ++lane) {
        const std::uint32_t point =
            packing->point[t.first_point + static_cast<std::uint32_t>(lane - t.lane_begin)];
        EXPECT_EQ(located.triangle[point], t.triangle);
        ++seen[point];
      }
    }
    EXPECT_EQ(lane, packet.lane_count);
  }
  EXPECT_EQ(seen, std::vector<int>(points_.size(), 1));
}

TEST_F(Packed, the_triangles_of_a_packet_are_a_tree_over_edges_that_rays_pass_both_ways) {
  const Result<Packing> packing = pack(context_, scene_, locate(context_));
  ASSERT_TRUE(packing.ok());
  std::size_t children = 0;
  for (const Packet& packet : packing->packet) {
    const PacketTriangle* member = packing->triangle.data() + packet.first_triangle;
    for (int i = 1; i < packet.triangle_count; ++i, ++children) {
      ASSERT_LT(member[i].parent, i);
      const PacketTriangle& parent = member[member[i].parent];
      const SceneTriangle& above = scene_.triangle[parent.triangle];
      const SceneTriangle& own = scene_.triangle[member[i].triangle];
      EXPECT_EQ(above.twin[member[i].parent_edge],
                static_cast<std::int32_t>(3 * member[i].triangle + member[i].own_edge));
      EXPECT_GE(above.edge[member[i].parent_edge], 0);
      EXPECT_GE(own.edge[member[i].own_edge], 0);
    }
  }
  EXPECT_GT(children, 100u);
}

TEST_F(Packed, packets_of_a_dense_list_are_nearly_full) {
  const Result<Packing> packing = pack(context_, scene_, locate(context_));
  ASSERT_TRUE(packing.ok());
  EXPECT_GT(static_cast<double>(points_.size()) / static_cast<double>(packing->packet.size()), 10);
}

}  // namespace
}  // namespace sfumato::gather::test
