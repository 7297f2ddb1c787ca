#pragma once

#include <array>
#include <optional>

#include "patches/patch.hpp"
#include "patches/picture.hpp"

namespace sfumato::test {

/// The colour of a layer's patches at a point, by trying every triangle: slow, and independent of
/// the rasterizer. Nothing where no triangle contains the point.
inline std::optional<std::array<double, 3>> sample(const PatchLayer& layer, Vec2 p) {
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    const std::uint32_t* corner = layer.triangle_vertex.data() + 3 * std::size_t{t};
    const Vec2 a = layer.vertex_position[corner[0]], b = layer.vertex_position[corner[1]],
               c = layer.vertex_position[corner[2]];
    const double area = cross(b - a, c - a);
    const double w = cross(b - p, c - p) / area, u = cross(c - p, a - p) / area,
                 v = cross(a - p, b - p) / area;
    if (w < 0 || u < 0 || v < 0) continue;
    const auto basis = patch_basis(layer.order, w, u, v);
    std::array<double, 3> color{};
    for (int n = 0; n < kNodesPerTriangle; ++n) {
      const std::uint32_t node = layer.color.triangle_node[std::size_t{10} * t + n];
      for (int channel = 0; channel < 3; ++channel) {
        color[channel] +=
            basis[n] *
            layer.color.node_value[std::size_t(layer.color.channel_count) * node + channel];
      }
    }
    return color;
  }
  return std::nullopt;
}

}  // namespace sfumato::test
