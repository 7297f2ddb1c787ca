#pragma once

#include "gather/kernels/scene_layout.hpp"

/// The output of the kernel of rows: plain structures in single precision.
namespace sfumato::gather {

/// The part of one hit edge that some adjacent lanes of a packet see. The lists of lanes may be cut
/// otherwise where registers are wider; the parts of each lane, and their order, are the same.
struct alignas(64) RowView {
  float weight[kPacketLanes];  ///< with k = 1
  float lean[kPacketLanes];  ///< the weight's mean place, from -1 at a to 1 at b, times the weight
  float from[kPacketLanes];  ///< the visible part, as fractions of the way from a to b
  float to[kPacketLanes];
  std::uint32_t hit;    ///< index of the edge
  std::uint32_t lanes;  ///< of the arrays above, bit by bit
  int first_lane;       ///< of the packet: the first of the arrays above
};

/// Receives the views of a packet as they are found.
struct RowTaker {
  void* self;
  void (*take)(void* self, const RowView* view, int count);
  /// Views below this share of a lane's weight need not be found.
  float negligible;
};

}  // namespace sfumato::gather
