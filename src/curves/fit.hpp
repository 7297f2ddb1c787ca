#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::curves {

/// Options of fit_curve().
struct FitOptions {
  double tolerance = 1;  ///< the largest distance of a point from the curve, user units, above 0
  /// The direction over `corner_reach` points before and after a point turns by more than this at a
  /// corner, degrees.
  double corner_deg = 50;
  int corner_reach = 4;
};

/// Fits a chain of cubic Béziers to points at about even distances: within the tolerance of each
/// point, and smooth except at corners (Schneider 1990). A loop, whose last point equals its first,
/// is closed, and also smooth there unless it has a corner.
///
/// points           at least 2, not all the same
/// control_points   becomes 3 n + 1, at most most_control_points() of the number of points; the
///                  first and the last are points, and so are corners
///
/// Cost: O(points · log points + corners²).
void fit_curve(std::span<const Vec2> points, const FitOptions& options,
               std::vector<Vec2>& control_points);

/// Returns the largest number of control points for this many points, at least 1: a piece between
/// each two points.
constexpr std::size_t most_control_points(std::size_t points) {
  return 3 * (points - 1) + 1;
}

}  // namespace sfumato::curves
