#pragma once

#include <vector>

#include "sfumato/document/curve.hpp"

namespace sfumato::curves {

/// The steepest change of the picture across a blurred curve. At such a curve a chord that deviates
/// from it shows as a wrong colour, not as a displaced edge (docs/mathematics.md).
class BlurSlope {
 public:
  /// Radii below `sharp_radius` count as 0.
  BlurSlope(const Curve& curve, double sharp_radius);

  /// Returns the slope in the middle of a range of the curve's parameter, code values (0 to 255)
  /// per user unit; 0 where the curve is sharp.
  double between(double from, double to) const;

 private:
  struct RadiusStop {
    double parameter;
    double radius;
  };

  static double radius_at(const std::vector<RadiusStop>& stops, double parameter);

  std::vector<std::vector<RadiusStop>> radii_;  ///< of the sides with blur
  double sharp_radius_;
  double step_ = 0;  ///< the largest difference between the sides, code values
};

}  // namespace sfumato::curves
