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
  /// most     the largest distance of interest, user units
  /// same     curves this near to each other coincide, user units
  NearCurves(std::span<const Curve> curves, const FlatCurves& coarse, double most, double same)
      : curves_(curves), coarse_(coarse), most_(most), same_(same) {}

  /// Builds the search; call it first. Errors: limit (memory), cancelled; no other function may
  /// then be called.
  Status build(Context& context) { return tree_.build(context, coarse_, curves_, most_); }

  /// Returns the distance from a part of a segment to the nearest other segment, except those that
  /// it joins on its own curve, that coincide with it, or that it meets at a large angle; at most
  /// `most`, and 0 where very many are near.
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
