#pragma once

#include <cstdint>

#include "base/lanes.hpp"

/// Windows: ranges of directions from the points of a packet through an edge of the visibility
/// mesh.
namespace sfumato::gather::inline SFUMATO_ISA {

template <class F>
struct Direction {
  F x, y;
};

template <class F>
SFUMATO_INLINE Direction<F> select(const typename F::Mask& mask, const Direction<F>& a,
                                   const Direction<F>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
}

/// Lanes of a packet as bits: lane i is bit i.
using LaneBits = std::uint32_t;

/// The range of directions towards an edge, for each lane: from `right` counter-clockwise (cross >
/// 0) to `left`. Both point to mesh vertices, relative to the lane's point.
template <class F>
struct Window {
  Direction<F> right;
  Direction<F> left;
  LaneBits lanes;        ///< the values of other lanes are unspecified
  LaneBits whole_right;  ///< lanes whose right ray points to the edge's right end (not cut there)
  LaneBits whole_left;
};

/// The parts of a window that is split at a triangle's apex.
template <class F>
struct Split {
  Direction<F> apex;
  typename F::Mask turns_right;  ///< the window reaches right of the apex
  typename F::Mask turns_left;
  LaneBits right;  ///< the lanes of the window that turn right
  LaneBits left;

  SFUMATO_INLINE Split(const Window<F>& w, const Direction<F>& apex_direction)
      : apex(apex_direction),
        turns_right(w.right.x * apex.y > w.right.y * apex.x),
        turns_left(apex.x * w.left.y > apex.y * w.left.x),
        right(w.lanes & mask_bits(turns_right)),
        left(w.lanes & mask_bits(turns_left)) {}

  SFUMATO_INLINE Window<F> right_of(const Window<F>& w) const {
    return {w.right, select(turns_left, apex, w.left), right, w.whole_right, left};
  }
  SFUMATO_INLINE Window<F> left_of(const Window<F>& w) const {
    return {select(turns_right, apex, w.right), w.left, left, right, w.whole_left};
  }
};

}  // namespace sfumato::gather::inline SFUMATO_ISA
