#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "picture/patch.hpp"
#include "sfumato/picture/picture.hpp"

/// Small pictures for the tests of the rasterizer.
namespace sfumato::test {

using Corners = std::array<std::uint32_t, 3>;
/// Colour at a point of the layer frame, on one side of the curves.
using ColorField = std::function<Rgb(int region, Vec2 p)>;

/// The same for opacity, or the weight of a shader.
using ScalarField = std::function<float(int region, Vec2 p)>;

/// A triangulation whose regions are divided by curves.
struct RegionMesh {
  std::vector<Vec2> vertex;
  std::vector<Corners> triangle;
  std::vector<int> region;  ///< one per triangle

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, int triangle_region) {
    triangle.push_back({a, b, c});
    region.push_back(triangle_region);
  }
};

/// Returns a layer with ten separate nodes for each triangle, read from `color`. An edge is a curve
/// if the regions on its sides differ.
inline PatchLayer make_layer(const RegionMesh& mesh, const ColorField& color) {
  PatchLayer layer;
  layer.vertex_position = mesh.vertex;
  for (Vec2 p : mesh.vertex) layer.frame.extend(p);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> region_of_edge;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      region_of_edge[{mesh.triangle[t][k], mesh.triangle[t][(k + 1) % 3]}] = mesh.region[t];
  }
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const Corners& corner = mesh.triangle[t];
    for (int k = 0; k < 3; ++k) {
      layer.triangle_vertex.push_back(corner[k]);
      const auto twin = region_of_edge.find({corner[(k + 1) % 3], corner[k]});
      layer.edge_is_curve.push_back(twin != region_of_edge.end() && twin->second != mesh.region[t]);
    }
    for (const auto& weight : kNodeBarycentric) {
      Vec2 p;
      for (int k = 0; k < 3; ++k) p = p + mesh.vertex[corner[k]] * weight[k];
      const Rgb value = color(mesh.region[t], p);
      layer.color.triangle_node.push_back(
          static_cast<std::uint32_t>(layer.color.node_value.size() / 3));
      for (float channel : {value.r, value.g, value.b}) layer.color.node_value.push_back(channel);
    }
  }
  return layer;
}

/// Returns one value for each node of a layer of make_layer.
inline std::vector<float> node_values(const RegionMesh& mesh, const ScalarField& value) {
  std::vector<float> values;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (const auto& weight : kNodeBarycentric) {
      Vec2 p;
      for (int k = 0; k < 3; ++k) p = p + mesh.vertex[mesh.triangle[t][k]] * weight[k];
      values.push_back(value(mesh.region[t], p));
    }
  }
  return values;
}

/// Gives a layer of make_layer an opacity.
inline void set_opacity(const RegionMesh& mesh, const ScalarField& opacity, PatchLayer* layer) {
  layer->opacity = {1, layer->color.triangle_node, node_values(mesh, opacity), {}};
}

/// Gives one of the fields of such a layer the weight of a shader.
inline void add_weight(const RegionMesh& mesh, std::uint32_t shader, const ScalarField& weight,
                       PatchField* field) {
  const std::vector<float> added = node_values(mesh, weight);
  const std::size_t channels = static_cast<std::size_t>(field->channel_count);
  std::vector<float> values;
  for (std::size_t node = 0; node < added.size(); ++node) {
    for (std::size_t c = 0; c < channels; ++c)
      values.push_back(field->node_value[node * channels + c]);
    values.push_back(added[node]);
  }
  field->node_value = std::move(values);
  field->channel_count += 1;
  field->shader.push_back(shader);
}

inline Picture make_picture(PatchLayer layer) {
  Picture picture;
  picture.artboard = picture.viewport = layer.frame;
  picture.layers.push_back(std::move(layer));
  picture.stack.push_back(PatchInstance{});
  return picture;
}

/// Returns a grid of `cells`² quads over the box, with inner vertices moved at random and each quad
/// cut along a diagonal; region_of gives the region of a quad.
inline RegionMesh jittered_grid(const Box& box, int cells, std::uint32_t seed,
                                const std::function<int(int column, int row)>& region_of) {
  std::mt19937 random(seed);
  const auto jitter = [&] { return (random() / 4294967296.0 - 0.5) * 0.6; };
  RegionMesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = i + (i > 0 && i < cells ? jitter() : 0);
      const double y = j + (j > 0 && j < cells ? jitter() : 0);
      mesh.vertex.push_back(
          {box.min.x + box.width() * x / cells, box.min.y + box.height() * y / cells});
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto at = [&](int column, int row) {
        return static_cast<std::uint32_t>(row * (cells + 1) + column);
      };
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      const int region = region_of(i, j);
      if (random() & 1) {
        mesh.add(a, b, c, region);
        mesh.add(a, c, d, region);
      } else {
        mesh.add(a, b, d, region);
        mesh.add(b, c, d, region);
      }
    }
  }
  return mesh;
}

inline RegionMesh jittered_grid(const Box& box, int cells, std::uint32_t seed) {
  return jittered_grid(box, cells, seed, [](int, int) { return 0; });
}

/// Returns one colour over a box.
inline PatchLayer flat_layer(const Box& box, const Rgb& color) {
  return make_layer(jittered_grid(box, 2, 1), [&](int, Vec2) { return color; });
}

/// The same with one opacity.
inline PatchLayer flat_layer(const Box& box, const Rgb& color, float opacity) {
  const RegionMesh mesh = jittered_grid(box, 2, 1);
  PatchLayer layer = make_layer(mesh, [&](int, Vec2) { return color; });
  set_opacity(
      mesh, [&](int, Vec2) { return opacity; }, &layer);
  return layer;
}

/// Returns two regions that meet on the line through a and b, which must cross the box's opposite
/// sides. Region 0 is left of a → b on the screen. The box is cut into two quads or more.
inline RegionMesh cut_box(const Box& box, Vec2 a, Vec2 b) {
  RegionMesh mesh;
  const Vec2 p0 = box.min, p1{box.max.x, box.min.y}, p2 = box.max, p3{box.min.x, box.max.y};
  if (a.y == box.max.y && b.y == box.min.y) {  // upwards: left of the line is the left part
    mesh.vertex = {p0, b, a, p3, p1, p2};
    mesh.add(0, 1, 2, 0);
    mesh.add(0, 2, 3, 0);
    mesh.add(1, 4, 5, 1);
    mesh.add(1, 5, 2, 1);
  } else {  // rightwards: left of the line is the upper part
    mesh.vertex = {p0, p1, b, a, p2, p3};
    mesh.add(0, 1, 2, 0);
    mesh.add(0, 2, 3, 0);
    mesh.add(3, 2, 4, 1);
    mesh.add(3, 4, 5, 1);
  }
  return mesh;
}

}  // namespace sfumato::test
