#pragma once

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
/// points    at least 2, not all the same
/// Returns   3 n + 1 control points; the first and the last are points, and so are corners
/// Cost      O(points · log points + corners²)
std::vector<Vec2> fit_curve(std::span<const Vec2> points, const FitOptions& options);

}  // namespace sfumato::curves
