#pragma once

#include <cstdint>

#include "base/inline.hpp"
#include "gather/kernels/far_field.hpp"
#include "gather/kernels/negligible.hpp"

/// The layer in the layout of the kernels: plain structures in single precision, coordinates
/// relative to the scene's origin. Kernels are compiled for several instruction sets and use no
/// other types.
namespace sfumato::gather {

/// The effect of an edge of a triangle on rays, as one number: an EdgeBeyond to walk through (>=
/// 0), kBorder (the border, or a barrier: it stops rays and adds nothing), or a HitEdge.
using EdgeCode = std::int32_t;
inline constexpr EdgeCode kBorder = -1;

SFUMATO_INLINE constexpr EdgeCode hit_code(std::uint32_t index) {
  return -2 - static_cast<EdgeCode>(index);
}
SFUMATO_INLINE constexpr bool is_hit(EdgeCode code) {
  return code <= -2;
}
/// Returns the index of a hit edge. Precondition: is_hit(code).
SFUMATO_INLINE constexpr std::uint32_t hit_index(EdgeCode code) {
  return static_cast<std::uint32_t>(-2 - code);
}

/// A half-edge that rays walk through, and the triangle behind it: its third corner, and the two
/// edges by which a ray may leave it, right and left as seen through the half-edge.
struct alignas(32) EdgeBeyond {
  float apex_x;
  float apex_y;
  EdgeCode right;  ///< from the half-edge's origin to the apex
  EdgeCode left;   ///< from the apex to its target
  float normal_x;  ///< normal · p + offset: the distance of a point from the half-edge's line
  float normal_y;
  float offset;
};

/// Channels of a curve_domain value. SegmentAttributes::base_channels of them are used.
inline constexpr int kValueChannels = 4;

/// A half-edge a → b that stops rays, seen from its own triangle: a is the right end, b the left.
/// The value is linear from a to b: middle ∓ half_change. Values are multiplied with the weight.
struct alignas(64) HitEdge {
  float ax, ay;
  float bx, by;
  float ex, ey;  ///< b - a
  float length_squared;
  float weight;                  ///< k, relative to the largest of the layer
  float middle[kValueChannels];  ///< weight × the mean of both ends; 0 for an image-domain shader
  float half_change[kValueChannels];  ///< weight × half of (value at b - value at a)
};

/// The data for blur and image-domain shaders at a HitEdge (paper eq. 7–11). `back` is the other
/// side.
struct alignas(64) HitBlend {
  float inverse_length;
  float blur_middle;  ///< R of eq. 8 is linear from a to b: middle ∓ half_change; 0: sharp
  float blur_half_change;
  std::int32_t front_shader;  ///< index of an image-domain side's weight channel; -1: curve_domain
  std::int32_t back_shader;
  float back_middle[kValueChannels];  ///< weight × z_B, as in HitEdge
  float back_half_change[kValueChannels];
};

/// A triangle and the codes of its edges; edge k joins corner k and corner (k + 1) % 3.
struct SceneTriangle {
  float x[3];
  float y[3];
  EdgeCode edge[3];
  std::int32_t twin[3];  ///< half-edge on the other side, whatever is between them; -1 on the hull
};

/// A rectangle; the default is empty.
struct EndBox {
  float x0 = __builtin_huge_valf(), y0 = __builtin_huge_valf();
  float x1 = -__builtin_huge_valf(), y1 = -__builtin_huge_valf();
};

/// The term of a FreeEnd, with the same members.
struct EndTerm {
  float x, y;
  float direction_x, direction_y;
  float bend;
  float inverse_reach_squared;
  float weight;  ///< c k
  float blur_positive, blur_negative;
  float positive[kValueChannels];
  float negative[kValueChannels];
};

/// The term bends down from c k / r² at a fifth of the reach.
inline constexpr float kEndKnee = 25;

inline constexpr std::uint32_t kEndsPerLeaf = 4;

/// A tree of boxes. The children of node i are 2 i and 2 i + 1; the root is 1. The leaves are the
/// last nodes; each leaf has the next kEndsPerLeaf terms.
struct EndTree {
  const EndTerm* term = nullptr;
  const EndBox* box = nullptr;  ///< per node: the reach of its terms
  std::uint32_t term_count = 0;
  std::uint32_t leaf_count = 0;  ///< a power of two; 0 where there are no terms
};

struct SceneView {
  const EdgeBeyond* edge_beyond;
  const HitEdge* hit_edge;
  const HitBlend* blend;  ///< per hit edge; null: all sides are sharp and curve_domain
  int base_channels;
  int shader_count;
  const SceneTriangle* triangle;
  std::int64_t step_limit;  ///< triangles that one packet may enter; guards against a bad mesh
  EndTree ends{};
  FarField far{};
  float negligible = kNegligible;  ///< share of the weight that a window may add unfollowed
};

inline constexpr int kPacketLanes = 16;
inline constexpr int kPacketTriangles = 8;

/// Lanes [lane_begin, lane_end) of a packet are points of `triangle`. The triangles of a packet
/// form a tree over edges that rays pass in both directions; parents come before children.
struct PacketTriangle {
  std::uint32_t triangle;
  std::uint32_t first_point;  ///< of lane_begin, in packing order
  std::uint8_t lane_begin;
  std::uint8_t lane_end;
  std::uint8_t parent;       ///< index in the packet
  std::uint8_t parent_edge;  ///< the parent's edge towards this triangle
  std::uint8_t own_edge;     ///< this triangle's edge towards the parent
};

/// One packet: neighbouring points that are gathered together. Unused lanes repeat a point.
struct PacketInput {
  const PacketTriangle* triangle;
  int triangle_count;
  alignas(64) float x[kPacketLanes];
  alignas(64) float y[kPacketLanes];
};

/// W, and Z_C / W of eq. 6, per lane, both with the terms of free ends; where W is 0, all other
/// results are 0.
struct PacketResult {
  alignas(64) float weight[kPacketLanes];
  alignas(64) float value[kValueChannels][kPacketLanes];  ///< base_channels of them
  /// W_s / W: kPacketLanes floats for each of SceneView::shader_count, one after another.
  float* shader_share;
};

struct PacketBatch {
  const PacketInput* packet;
  PacketResult* result;  ///< one for each packet
  int count;
};

/// Room for one window on the kernel's stack, in any width.
struct alignas(64) StackSlot {
  unsigned char bytes[6 * 64];
};

struct PacketStack {
  StackSlot* slot;
  int capacity;  ///< at least kPacketStackLeast
};
inline constexpr int kPacketStackLeast = 64;

}  // namespace sfumato::gather
