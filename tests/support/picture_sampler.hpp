#pragma once

#include <array>
#include <optional>
#include <vector>

#include "picture/patch.hpp"
#include "sfumato/picture/picture.hpp"

namespace sfumato::test {

/// Returns all channels of a layer's field at a point, by trying every triangle: slow, and
/// independent of the rasterizer. Nothing if no triangle contains the point.
inline std::optional<std::vector<double>> sample_field(const PatchLayer& layer,
                                                       const PatchField& field, Vec2 p) {
  for (std::uint32_t t = 0; t < layer.triangle_count(); ++t) {
    const std::uint32_t* corner = layer.triangle_vertex.data() + 3 * std::size_t{t};
    const Vec2 a = layer.vertex_position[corner[0]], b = layer.vertex_position[corner[1]],
               c = layer.vertex_position[corner[2]];
    const double area = cross(b - a, c - a);
    const double w = cross(b - p, c - p) / area, u = cross(c - p, a - p) / area,
                 v = cross(a - p, b - p) / area;
    if (w < 0 || u < 0 || v < 0) continue;
    const auto basis = patch_basis(layer.order, w, u, v);
    const auto channels = static_cast<std::size_t>(field.channel_count);
    std::vector<double> value(channels);
    for (int n = 0; n < kNodesPerTriangle; ++n) {
      const std::uint32_t node = field.triangle_node[std::size_t{10} * t + n];
      for (std::size_t c0 = 0; c0 < channels; ++c0) {
        value[c0] += basis[n] * field.node_value[channels * node + c0];
      }
    }
    return value;
  }
  return std::nullopt;
}

/// Returns only the colour channels.
inline std::optional<std::array<double, 3>> sample(const PatchLayer& layer, Vec2 p) {
  const auto value = sample_field(layer, layer.color, p);
  if (!value) return std::nullopt;
  return std::array{(*value)[0], (*value)[1], (*value)[2]};
}

}  // namespace sfumato::test
