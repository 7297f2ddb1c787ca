#pragma once

#include "gather/kernels/scene_layout.hpp"

/// What the kernel of rows gives: plain structures in single precision.
namespace sfumato::gather {

/// What some lanes of a packet, neighbours of each other, see of one hit edge. The lists of lanes
/// may be cut otherwise where registers are wider; what each lane sees, and in which order, is the
/// same.
struct alignas(64) RowView {
  float weight[kPacketLanes];  ///< with k = 1
  float lean[kPacketLanes];  ///< the weight's mean place, from -1 at a to 1 at b, times the weight
  float from[kPacketLanes];  ///< the part that is seen, as fractions of the way from a to b
  float to[kPacketLanes];
  std::uint32_t hit;    ///< index of the edge
  std::uint32_t lanes;  ///< of the arrays above, bit by bit
  int first_lane;       ///< of the packet: the first of the arrays above
};

/// Gets the views of a packet as they are found.
struct RowTaker {
  void* self;
  void (*take)(void* self, const RowView* view, int count);
  /// What weighs less than this share of a lane's weight need not be found.
  float negligible;
};

}  // namespace sfumato::gather
