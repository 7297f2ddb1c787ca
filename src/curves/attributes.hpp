#pragma once

#include <cstdint>
#include <vector>

#include "base/color.hpp"
#include "curves/flatten.hpp"

namespace sfumato::curves {

/// The values of an attribute at both ends of a segment, from within the segment (a step at an end
/// belongs to the neighbour). Linear in between.
template <class Value>
struct SegmentValues {
  Value start{};
  Value end{};
};

/// The colour shader of one side of one segment.
struct SegmentColor {
  ShaderKind kind = ShaderKind::open;
  std::uint32_t shader = 0;
  SegmentValues<Rgb> color;
};

/// Attributes of every segment of `flat` (index = segment = its first vertex; the entries of
/// vertices that begin no segment are open).
struct SegmentAttributes {
  std::vector<SegmentColor> left;
  std::vector<SegmentColor> right;
  std::vector<float> weight;         ///< the curve's
  std::vector<Vec2> vertex;          ///< FlatCurves::vertex: segment s joins s and s + 1
  std::vector<std::uint32_t> curve;  ///< index of the curve: later ones are drawn over earlier
};

SegmentAttributes sample_colors(const FlatCurves& flat, std::span<const Curve> curves);

}  // namespace sfumato::curves
