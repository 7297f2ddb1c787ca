#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/color.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

inline constexpr int kNodesPerTriangle = 10;  ///< of a cubic patch

/// Where the node at a place, 0 to 9, of a triangle stands in PatchField::triangle_node.
constexpr std::size_t node_slot(std::size_t triangle, std::size_t place) {
  return kNodesPerTriangle * triangle + place;
}

/// Interpolation inside a triangle (paper appendix A). Ten nodes are stored for each.
enum class PatchOrder : std::uint8_t { linear, quadratic, cubic };

/// Values that are interpolated over the triangles of a layer.
///
/// The ten nodes of triangle t with corners 0, 1, 2 stand in this order (paper Fig. 3, eq. 18):
/// Z0 Z1 Z2  Z01 Z10  Z12 Z21  Z20 Z02  Z012 — Zij lies on edge ij, a third of the way from i.
/// The barycentric weight of corner 0 is the paper's w, of corner 1 its u, of corner 2 its v.
struct PatchField {
  int channel_count = 0;                     ///< 0: the layer has no such field
  std::vector<std::uint32_t> triangle_node;  ///< kNodesPerTriangle per triangle
  std::vector<float> node_value;             ///< channel_count per node
  /// Image-domain shaders by their weights W_s/W, the last channels: indices into Picture::shaders.
  std::vector<std::uint32_t> shader;
};

/// One side of an edge that is blurred too finely for triangles: they show it sharp, and an output
/// in pixels averages the blur of eq. 8 over them. At distance r from the edge the side shows a
/// share (1 - β(r/R)) of what lies across; R, where that ends, grows along the edge.
struct SoftEdge {
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::uint32_t front = kNone;  ///< the edge in the side's triangle t: 3 t + k; none: transparent
  std::uint32_t back = kNone;   ///< the same edge in the triangle across
  /// From the ends of `front`, origin first, to where the blur ends, layer frame: of length R on a
  /// straight curve, and to the common corner of the blurs of two edges at a corner.
  Vec2 reach[2];
  /// What lies across is front + contrast (back - front): 2 where the triangle across shows, on the
  /// edge, the mean of both sides, since its own blur is one of the mesh; else 1.
  float contrast = 1;
};

/// One solved layer: triangular patches over shared nodes (paper eq. 6 and 10).
///
/// The colour at a point is color's channels 0 to 2, in the space of Picture::interpolation, plus
/// the weight of each shader times its colour there; opacity is channel 0 of `opacity`, plus
/// weights times alpha × luminance.
struct PatchLayer {
  Box frame;  ///< the triangles cover what is seen of this rectangle of the layer frame
  PatchOrder order = PatchOrder::cubic;
  std::vector<Vec2> vertex_position;           ///< layer frame
  std::vector<std::uint32_t> triangle_vertex;  ///< 3 per triangle, cross(01, 02) > 0
  /// 3 per triangle, edge k from corner k to corner (k+1)%3: 1 where the picture may jump, or ends.
  std::vector<std::uint8_t> edge_is_curve;
  std::vector<SoftEdge> soft_edge;  ///< in the order of soft_edge_triangle
  PatchField color{3, {}, {}, {}};  ///< 3 channels and one for each of its shaders
  PatchField opacity;               ///< 1 channel and one for each of its shaders; none: opaque

  std::uint32_t triangle_count() const {
    return static_cast<std::uint32_t>(triangle_vertex.size() / 3);
  }
};

/// The triangle that a soft edge is painted with: that of its side, if there is one.
inline std::uint32_t soft_edge_triangle(const SoftEdge& edge) {
  return (edge.front != SoftEdge::kNone ? edge.front : edge.back) / 3;
}

/// A solved layer painted at one place of the stacking order.
struct PatchInstance {
  std::uint32_t layer = 0;
  Affine artboard_from_layer;
  float opacity = 1;
  BlendMode blend = BlendMode::normal;
};

using PictureItem = std::variant<PatchInstance, LocalStroke, GroupBegin, GroupEnd>;

/// A resolution-independent picture: what every output is made from.
struct Picture {
  Box artboard;  ///< user units, y down
  Box viewport;  ///< the part that was solved; inside it every pixel is covered
  InterpolationSpace interpolation = InterpolationSpace::srgb;
  std::optional<Rgb> background;
  std::vector<Shader> shaders;
  std::vector<PatchLayer> layers;
  std::vector<PictureItem> stack;  ///< bottom first; groups as in Document::stack
};

/// About what they take in memory. `diffuse` charges it only while it works: who holds a picture
/// may charge it again.
std::size_t bytes_of(const PatchLayer& layer);
std::size_t bytes_of(const Picture& picture);

}  // namespace sfumato
