#pragma once

#include <vector>

#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// How fast the colours and opacities of a curve's sides change along it.
class StopSlope {
 public:
  explicit StopSlope(const Curve& curve);

  /// Returns the steepest change in a range of the curve's parameter, code values (0 to 255) per
  /// user unit of the straight line between two stops.
  double between(double from, double to) const;

 private:
  struct Stretch {
    double from, to;  ///< parameters of two stops that follow each other
    double slope;
  };

  template <class Value>
  void add(const Curve& curve, const StopList<Value>& stops);

  std::vector<std::vector<Stretch>> stretches_;  ///< of each list of stops
};

}  // namespace sfumato::curves
