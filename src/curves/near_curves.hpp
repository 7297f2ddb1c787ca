#pragma once

#include <cstdint>
#include <span>

#include "curves/flatten.hpp"
#include "curves/segment_tree.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// Measures how near curves pass each other.
class NearCurves {
 public:
  /// coarse   polylines of the curves, with vertices on them; it must outlive this
  /// most     distance() returns at most this, user units
  /// same     points within this distance count as equal, user units
  NearCurves(std::span<const Curve> curves, const FlatCurves& coarse, double most, double same)
      : curves_(curves), coarse_(coarse), most_(most), same_(same) {}

  /// Builds the search; call it first. Errors: limit (memory), cancelled; no other function may
  /// then be called.
  Status build(Context& context) { return tree_.build(context, coarse_, curves_, most_); }

  /// Returns the distance from a part of a segment to the nearest other segment, user units, at
  /// most `most`. Ignores the neighbours on the same curve, segments that coincide with this one,
  /// and segments that meet it at more than 30 degrees. Returns 0 if too many segments are near to
  /// measure all of them.
  double distance(std::uint32_t segment, Vec2 from, Vec2 to) const;

 private:
  bool is_joined(std::uint32_t a, std::uint32_t b) const;
  bool coincide(std::uint32_t a, std::uint32_t b) const;
  bool part_at_once(std::uint32_t a, std::uint32_t b) const;
  Vec2 middle(std::uint32_t segment) const;

  std::span<const Curve> curves_;
  const FlatCurves& coarse_;
  double most_;
  double same_;
  SegmentTree tree_;
};

}  // namespace sfumato::curves
