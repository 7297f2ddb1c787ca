// One drawing that is placed many times, compared with the same drawing written out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>

#include "raster/pictures.hpp"
#include "raster/support.hpp"

namespace sfumato::test {
namespace {

/// Bends within a triangle, as blurs do.
Rgb steep(int region, Vec2 p) {
  const auto wave = [&](double a, double b) {
    return static_cast<float>(0.5 + 0.55 * std::sin(a * p.x + b * p.y + region));
  };
  return {wave(3.1, 1.2), wave(-2.7, 2.3), wave(0.5, -4)};
}

float soft(int region, Vec2 p) {
  return static_cast<float>(0.6 + 0.5 * std::cos(2 * p.x - 3 * p.y + region));
}

/// Returns a layer whose rim is a curve too, so that the rule about pixel centres does not apply.
PatchLayer soft_layer() {
  const RegionMesh mesh =
      jittered_grid({{-3, -3}, {3, 3}}, 12, 4, [](int i, int j) { return (i / 3 + j / 4) % 3; });
  PatchLayer layer = make_layer(mesh, steep);
  set_opacity(mesh, soft, &layer);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Corners& corner : mesh.triangle)
    for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(corner[k], corner[(k + 1) % 3])];
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const Corners& corner = mesh.triangle[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (edges[std::minmax(corner[k], corner[(k + 1) % 3])] == 1)
        layer.edge_is_curve[3 * t + k] = 1;
  }
  return layer;
}

/// Returns rotated and mirrored copies of all sizes: triangles are from a twentieth of a pixel to
/// 20 pixels.
std::vector<PatchInstance> places(int count) {
  std::mt19937 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  std::vector<PatchInstance> all;
  for (int i = 0; i < count; ++i) {
    const double scale = std::exp(uniform(std::log(0.1), std::log(40))), turn = uniform(0, 6.3);
    const double mirror = i % 2 == 0 ? 1 : -1;
    const double c = scale * std::cos(turn), s = scale * std::sin(turn);
    const auto mode = static_cast<BlendMode>(i % 3);
    all.push_back({0,
                   {mirror * c, mirror * s, -s, c, uniform(-10, 310), uniform(-10, 190)},
                   static_cast<float>(uniform(0.3, 1)),
                   mode});
  }
  return all;
}

/// Returns the instance's layer, transformed.
PatchLayer moved_layer(PatchLayer layer, const Affine& map) {
  for (Vec2& p : layer.vertex_position) p = map(p);
  if (map.determinant() > 0) return layer;
  // Triangles change their orientation: corners 1 and 2 are swapped, with their edges and nodes.
  for (std::size_t t = 0; t < layer.triangle_count(); ++t) {
    std::swap(layer.triangle_vertex[3 * t + 1], layer.triangle_vertex[3 * t + 2]);
    std::swap(layer.edge_is_curve[3 * t], layer.edge_is_curve[3 * t + 2]);
    for (PatchField* field : {&layer.color, &layer.opacity}) {
      std::uint32_t* node = field->triangle_node.data() + kNodesPerTriangle * t;
      std::swap(node[1], node[2]);
      std::swap(node[3], node[8]);
      std::swap(node[4], node[7]);
      std::swap(node[5], node[6]);
    }
  }
  return layer;
}

TEST(RasterInstances, many_of_one_layer_equal_as_many_layers) {
  const PatchLayer layer = soft_layer();
  Picture placed = make_picture(layer), written_out = placed;
  placed.stack.clear();
  written_out.stack.clear();
  written_out.layers.clear();
  for (const PatchInstance& instance : places(60)) {
    placed.stack.push_back(instance);
    PatchInstance alone = instance;
    alone.layer = static_cast<std::uint32_t>(written_out.layers.size());
    alone.artboard_from_layer = {};
    written_out.layers.push_back(moved_layer(layer, instance.artboard_from_layer));
    written_out.stack.push_back(alone);
  }
  for (Picture* picture : {&placed, &written_out})
    picture->artboard = picture->viewport = {{0, 0}, {300, 180}};
  const Image a = rasterized(placed, image_size(300, 180));
  const Image b = rasterized(written_out, image_size(300, 180));
  int worst = 0, painted = 0;
  for (int i = 0; i < 300 * 180; ++i) {
    for (int c = 0; c < 3; ++c) {
      const int value = channel(a, i % 300, i / 300, c);
      worst = std::max(worst, std::abs(value - channel(b, i % 300, i / 300, c)));
      painted += value != 65535;
    }
  }
  EXPECT_LE(worst, 2) << "steps of 65535";
  EXPECT_GT(painted, 300 * 180);
}

TEST(RasterInstances, they_have_the_same_bytes_for_any_instruction_set) {
  Picture placed = make_picture(soft_layer());
  placed.stack.clear();
  for (const PatchInstance& instance : places(40)) placed.stack.push_back(instance);
  placed.artboard = placed.viewport = {{0, 0}, {300, 180}};
  expect_same_for_every_instruction_set(placed, image_size(300, 180, PixelFormat::rgba16));
}

}  // namespace
}  // namespace sfumato::test
