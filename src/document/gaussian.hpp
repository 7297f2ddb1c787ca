#pragma once

#include <cmath>
#include <numbers>

namespace sfumato {

/// The blur radius whose transition has, at the curve, the slope of a Gaussian of standard
/// deviation 1 (docs/mathematics.md, "Blur radii").
inline const double kBlurRadiusOfSigma = 3 * std::sqrt(2 * std::numbers::pi) / 4;

}  // namespace sfumato
