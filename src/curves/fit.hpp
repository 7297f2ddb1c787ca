#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sfumato/base/vec2.hpp"

namespace sfumato::curves {

/// How a curve follows points.
struct FitOptions {
  double tolerance = 1;  ///< the largest distance of a point from the curve, user units, above 0
  /// The direction over `corner_reach` points before and after a point turns by more than this at a
  /// corner, degrees.
  double corner_deg = 50;
  int corner_reach = 4;
};

/// A chain of cubic Béziers along points that lie about evenly spaced: within the tolerance of
/// each, smooth but for corners (Schneider 1990). A loop, whose last point equals its first, is
/// closed, and smooth there too unless it has a corner.
///
/// points           at least 2, not all the same
/// control_points   becomes 3 n + 1, at most most_control_points() of the number of points; the
///                  first and the last are points, and so are corners
/// Cost             O(points · log points + corners²)
void fit_curve(std::span<const Vec2> points, const FitOptions& options,
               std::vector<Vec2>& control_points);

/// For so many points, at least 1: a piece between each two of them.
constexpr std::size_t most_control_points(std::size_t points) {
  return 3 * (points - 1) + 1;
}

}  // namespace sfumato::curves
