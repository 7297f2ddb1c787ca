#pragma once

#include <vector>

#include "sfumato/base/color.hpp"

namespace sfumato {

/// What a stop's offset counts.
enum class StopSpace : unsigned char {
  arc_length,  ///< fraction of the curve's length, 0 to 1
  parameter    ///< the curve's own parameter: Bézier piece i at t is i + t, 0 to the piece count
};

template <class Value>
struct Stop {
  double offset = 0;
  Value value{};

  friend bool operator==(const Stop&, const Stop&) = default;
};

/// An attribute along a curve: linear between stops, constant before the first and after the last.
/// Invariant: offsets are finite and never fall; two stops at one offset are a step.
template <class Value>
struct StopList {
  StopSpace space = StopSpace::parameter;
  std::vector<Stop<Value>> stops{};

  bool empty() const { return stops.empty(); }

  friend bool operator==(const StopList&, const StopList&) = default;
};

using ColorStops = StopList<Rgb>;
using ScalarStops = StopList<float>;

}  // namespace sfumato
