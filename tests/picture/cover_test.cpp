#include "picture/cover.hpp"

#include <gtest/gtest.h>

namespace sfumato {
namespace {

/// Returns a picture of one opaque layer, two triangles from (0, 0) to (10, 10).
Picture square() {
  Picture picture;
  picture.artboard = picture.viewport = {{0, 0}, {10, 10}};
  PatchLayer layer;
  layer.frame = picture.artboard;
  layer.vertex_position = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  layer.triangle_vertex = {0, 1, 2, 0, 2, 3};
  picture.layers = {layer};
  picture.stack = {PatchInstance{}};
  return picture;
}

constexpr Box kInside{{1, 1}, {9, 9}};

PatchInstance& instance(Picture& picture) {
  return std::get<PatchInstance>(picture.stack[0]);
}

TEST(Cover, an_opaque_layer_covers_what_its_triangles_fill) {
  EXPECT_TRUE(picture::covers(square(), kInside));
  EXPECT_TRUE(picture::covers(square(), square().viewport));
  EXPECT_FALSE(picture::covers(square(), {{1, 1}, {10.5, 9}}));
}

TEST(Cover, a_hole_counts) {
  Picture picture = square();
  picture.layers[0].triangle_vertex.resize(3);
  EXPECT_FALSE(picture::covers(picture, kInside));
  picture.layers[0].triangle_vertex.clear();
  EXPECT_FALSE(picture::covers(picture, kInside));
}

TEST(Cover, what_lets_the_background_through_does_not_cover) {
  Picture faint = square();
  instance(faint).opacity = 0.5f;
  EXPECT_FALSE(picture::covers(faint, kInside));
  Picture mixed = square();
  instance(mixed).blend = BlendMode::multiply;
  EXPECT_FALSE(picture::covers(mixed, kInside));
  Picture clear = square();
  clear.layers[0].opacity.channel_count = 1;
  EXPECT_FALSE(picture::covers(clear, kInside));
  Picture grouped = square();
  grouped.stack = {GroupBegin{0.5f, BlendMode::normal}, PatchInstance{}, GroupEnd{}};
  EXPECT_FALSE(picture::covers(grouped, kInside));
}

TEST(Cover, instances_are_placed) {
  Picture picture = square();
  instance(picture).artboard_from_layer = {2, 0, 0, 2, 100, 0};
  EXPECT_FALSE(picture::covers(picture, kInside));
  EXPECT_TRUE(picture::covers(picture, {{101, 1}, {119, 19}}));
}

TEST(Cover, nothing_covers_without_items) {
  Picture picture = square();
  picture.stack.clear();
  EXPECT_FALSE(picture::covers(picture, kInside));
}

}  // namespace
}  // namespace sfumato
