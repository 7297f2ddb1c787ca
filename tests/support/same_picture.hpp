#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "sfumato/picture/picture.hpp"

namespace sfumato::test {

template <class Item>
bool same_bits(const std::vector<Item>& a, const std::vector<Item>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}

inline bool same_bits(const PatchField& a, const PatchField& b) {
  return a.channel_count == b.channel_count && same_bits(a.triangle_node, b.triangle_node) &&
         same_bits(a.node_value, b.node_value) && same_bits(a.shader, b.shader);
}

inline bool same_soft_edges(const std::vector<SoftEdge>& a, const std::vector<SoftEdge>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].front != b[i].front || a[i].back != b[i].back || a[i].contrast != b[i].contrast ||
        !(a[i].reach[0] == b[i].reach[0]) || !(a[i].reach[1] == b[i].reach[1])) {
      return false;
    }
  }
  return true;
}

/// Returns the largest difference between the values at all places of fields with the same
/// triangles.
inline float largest_difference(const PatchField& a, const PatchField& b) {
  const auto channels = static_cast<std::size_t>(a.channel_count);
  float largest = 0;
  for (std::size_t i = 0; i < a.triangle_node.size(); ++i) {
    const float* const x = a.node_value.data() + channels * a.triangle_node[i];
    const float* const y = b.node_value.data() + channels * b.triangle_node[i];
    for (std::size_t c = 0; c < channels; ++c) largest = std::max(largest, std::fabs(x[c] - y[c]));
  }
  return largest;
}

/// Returns the difference of two pictures, ignoring the content of shaders; empty: none.
inline std::string difference_of(const Picture& a, const Picture& b) {
  if (!(a.artboard == b.artboard) || !(a.viewport == b.viewport)) return "artboard or viewport";
  if (a.interpolation != b.interpolation || a.background != b.background) return "colours";
  if (a.stack.size() != b.stack.size() || a.shaders.size() != b.shaders.size()) return "stack";
  for (std::size_t i = 0; i < a.stack.size(); ++i) {
    const auto *x = std::get_if<PatchInstance>(&a.stack[i]),
               *y = std::get_if<PatchInstance>(&b.stack[i]);
    if (a.stack[i].index() != b.stack[i].index()) return "stack";
    if (x && (x->layer != y->layer || !(x->artboard_from_layer == y->artboard_from_layer) ||
              x->opacity != y->opacity || x->blend != y->blend)) {
      return "stack item " + std::to_string(i);
    }
  }
  if (a.layers.size() != b.layers.size()) return "number of layers";
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    const PatchLayer &x = a.layers[i], &y = b.layers[i];
    if (x.order != y.order || !(x.frame == y.frame) ||
        !same_bits(x.vertex_position, y.vertex_position) ||
        !same_bits(x.triangle_vertex, y.triangle_vertex) ||
        !same_bits(x.edge_is_curve, y.edge_is_curve) ||
        !same_soft_edges(x.soft_edge, y.soft_edge) || !same_bits(x.color, y.color) ||
        !same_bits(x.opacity, y.opacity)) {
      return "layer " + std::to_string(i);
    }
  }
  return "";
}

}  // namespace sfumato::test
