#pragma once

#include <vector>

#include "sfumato/base/color.hpp"

namespace sfumato {

/// The unit of the offset of a stop along a curve.
enum class StopSpace : unsigned char {
  arc_length,  ///< fraction of the curve's length, 0 to 1
  parameter    ///< the curve's own parameter: Bézier piece i at t is i + t, 0 to the piece count
};

/// A value at one place of a curve.
template <class Value>
struct Stop {
  double offset = 0;  ///< the place, in units of StopList::space
  Value value{};      ///< the attribute there

  /// Compares offset and value exactly.
  friend bool operator==(const Stop&, const Stop&) = default;
};

/// An attribute along a curve: linear between stops, constant before the first and after the last.
template <class Value>
struct StopList {
  StopSpace space = StopSpace::parameter;  ///< the unit of all offsets
  /// Sorted by offset, none outside the curve. Two stops at one offset are a step.
  std::vector<Stop<Value>> stops{};

  /// Returns whether there are no stops.
  bool empty() const { return stops.empty(); }

  /// Compares exactly: equal lists have the same space and the same stops.
  friend bool operator==(const StopList&, const StopList&) = default;
};

/// Colours along a curve.
using ColorStops = StopList<Rgb>;
/// Numbers along a curve: opacities or radii.
using ScalarStops = StopList<float>;

}  // namespace sfumato
