#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sfumato/base/function_ref.hpp"
#include "sfumato/base/vec2.hpp"

namespace sfumato::tracing {

/// Red, green, blue as sRGB code values, and opacity.
using SideValue = std::array<float, 4>;

/// The stops of one side, by the curve's parameter.
struct SideStops {
  std::vector<double> place;
  std::vector<SideValue> value;
};

/// A curve on its way into the drawing; lengths in traced pixels.
struct TracedCurve {
  std::vector<Vec2> control_points;  ///< 3 n + 1
  std::array<SideStops, 2> side;     ///< left and right
  double scale = 1;                  ///< of the Gaussian at which its edge was found
  double benefit = 0;                ///< Σ strength² · scale over its edge
  double radius = 0;                 ///< of blur, of the whole curve
  double seen_radius = 0;            ///< blur of the edge alone, before any fit
  bool is_frame = false;             ///< along the picture's border: its left side has no colour
};

/// A place on a curve.
struct CurveSample {
  Vec2 point;
  double parameter = 0;  ///< piece + t
  Vec2 left;             ///< unit vector to the curve's left
};

/// Places at most about `step` apart, both ends of each piece among them.
std::vector<CurveSample> samples_along(const TracedCurve& curve, double step);
/// visit(sample) for each of them, without a table.
void for_each_sample(const TracedCurve& curve, double step,
                     FunctionRef<void(const CurveSample&)> visit);

/// Memory of curves, with all that they have.
std::size_t bytes_of(const std::vector<TracedCurve>& curves);

/// Where on a curve a parameter, piece + t, is.
Vec2 point_on(const TracedCurve& curve, double parameter);

/// Returns the rectangle of a picture's border as a closed curve, its inside on the right.
TracedCurve frame_of(int width, int height);

inline bool is_closed(const TracedCurve& curve) {
  return curve.control_points.front() == curve.control_points.back();
}

inline std::size_t stop_count(const TracedCurve& curve) {
  return curve.side[0].place.size() + curve.side[1].place.size();
}

/// Returns the value of a side at a place. Precondition: it has stops.
SideValue value_at(const SideStops& side, double parameter);

double length_of(const TracedCurve& curve);

}  // namespace sfumato::tracing
