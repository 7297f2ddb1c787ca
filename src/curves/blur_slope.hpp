#pragma once

#include <vector>

#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// How steeply the picture may change across a blurred curve: there a chord that strays shows as a
/// wrong colour, not as a displaced edge (docs/mathematics.md).
class BlurSlope {
 public:
  /// Radii below `sharp_radius` are none.
  BlurSlope(const Curve& curve, double sharp_radius);

  /// In the middle of a stretch of the curve's parameter, code values (0 to 255) to a user unit; 0
  /// where it is sharp.
  double between(double from, double to) const;

 private:
  struct RadiusStop {
    double parameter;
    double radius;
  };

  static double radius_at(const std::vector<RadiusStop>& stops, double parameter);

  std::vector<std::vector<RadiusStop>> radii_;  ///< of the sides that blur
  double sharp_radius_;
  double step_ = 0;  ///< the largest from side to side, code values
};

}  // namespace sfumato::curves
