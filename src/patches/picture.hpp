#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/affine.hpp"
#include "base/box.hpp"
#include "base/color.hpp"
#include "base/vec2.hpp"

namespace sfumato {

/// Interpolation inside a triangle (paper appendix A). Ten nodes are stored for each.
enum class PatchOrder : std::uint8_t { linear, quadratic, cubic };

/// One solved layer: triangular patches over shared nodes.
///
/// The ten nodes of triangle t with corners 0, 1, 2 stand in this order (paper Fig. 3, eq. 18):
/// Z0 Z1 Z2  Z01 Z10  Z12 Z21  Z20 Z02  Z012 — Zij lies on edge ij, a third of the way from i.
/// The barycentric weight of corner 0 is the paper's w, of corner 1 its u, of corner 2 its v.
struct PatchLayer {
  Box frame;  ///< the triangles cover at least this rectangle of the layer frame
  PatchOrder order = PatchOrder::cubic;
  int channel_count = 3;
  std::vector<Vec2> vertex_position;           ///< layer frame
  std::vector<std::uint32_t> triangle_vertex;  ///< 3 per triangle, cross(01, 02) > 0
  /// 3 per triangle, edge k from corner k to corner (k+1)%3: 1 where the picture may jump.
  std::vector<std::uint8_t> edge_is_curve;
  std::vector<std::uint32_t> triangle_node;  ///< 10 per triangle
  std::vector<float> node_value;  ///< channel_count per node: code values 0 to 1, then weights

  std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(triangle_vertex.size() / 3);
  }
};

/// A solved layer painted at one place of the stacking order.
struct PatchInstance {
  std::uint32_t layer = 0;
  Affine artboard_from_layer;
  float opacity = 1;
};

/// A resolution-independent picture: what every output is made from.
struct Picture {
  Box artboard;  ///< user units, y down
  Box viewport;  ///< the part that was solved; inside it every pixel is covered
  std::optional<Rgb> background;
  std::vector<PatchLayer> layers;
  std::vector<PatchInstance> stack;  ///< bottom first
};

}  // namespace sfumato
