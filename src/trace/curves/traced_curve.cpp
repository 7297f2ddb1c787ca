#include "trace/curves/traced_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/table_memory.hpp"
#include "curves/bezier.hpp"

namespace sfumato::tracing {
namespace {

double polygon_length(const curves::Cubic& cubic) {
  return length(cubic[1] - cubic[0]) + length(cubic[2] - cubic[1]) + length(cubic[3] - cubic[2]);
}

std::size_t piece_count(const TracedCurve& curve) {
  return (curve.control_points.size() - 1) / 3;
}

/// Returns the direction at t; where the curve stands still, that of its chord.
Vec2 direction_at(const curves::Cubic& cubic, double t) {
  Vec2 along = curves::derivative_at(cubic, t);
  if (length(along) < 1e-9) along = cubic[3] - cubic[0];
  const double norm = length(along);
  return norm > 0 ? along / norm : Vec2{1, 0};
}

}  // namespace

std::vector<CurveSample> samples_along(const TracedCurve& curve, double step) {
  std::vector<CurveSample> samples;
  for_each_sample(curve, step, [&](const CurveSample& sample) { samples.push_back(sample); });
  return samples;
}

void for_each_sample(const TracedCurve& curve, double step,
                     FunctionRef<void(const CurveSample&)> visit) {
  for (std::size_t i = 0; i < piece_count(curve); ++i) {
    const curves::Cubic cubic = curves::piece(curve.control_points, i);
    const int parts = std::max(2, static_cast<int>(std::ceil(polygon_length(cubic) / step)));
    for (int k = i == 0 ? 0 : 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      visit({curves::point_at(cubic, t), static_cast<double>(i) + t,
             left_of(direction_at(cubic, t))});
    }
  }
}

std::size_t bytes_of(const std::vector<TracedCurve>& curves) {
  std::size_t bytes = capacity_bytes(curves);
  for (const TracedCurve& curve : curves) {
    bytes += capacity_bytes(curve.control_points);
    for (const SideStops& side : curve.side) bytes += capacity_bytes(side.place, side.value);
  }
  return bytes;
}

TracedCurve frame_of(int width, int height) {
  const auto w = static_cast<double>(width), h = static_cast<double>(height);
  TracedCurve frame;
  frame.is_frame = true;
  const std::array<Vec2, 5> corner{{{0, 0}, {w, 0}, {w, h}, {0, h}, {0, 0}}};
  frame.control_points.push_back(corner[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int third = 1; third <= 3; ++third) {
      frame.control_points.push_back(third == 3 ? corner[i + 1]
                                                : lerp(corner[i], corner[i + 1], third / 3.0));
    }
  }
  return frame;
}

Vec2 point_on(const TracedCurve& curve, double parameter) {
  const std::size_t at = std::min(static_cast<std::size_t>(parameter), piece_count(curve) - 1);
  return curves::point_at(curves::piece(curve.control_points, at),
                          parameter - static_cast<double>(at));
}

SideValue value_at(const SideStops& side, double parameter) {
  const auto next = std::ranges::upper_bound(side.place, parameter);
  const auto i = static_cast<std::size_t>(next - side.place.begin());
  if (i == 0) return side.value.front();
  if (i == side.place.size()) return side.value.back();
  const double way = side.place[i] - side.place[i - 1];
  const double t = way > 0 ? (parameter - side.place[i - 1]) / way : 0.0;
  SideValue value;
  for (std::size_t c = 0; c < value.size(); ++c) {
    value[c] =
        static_cast<float>(side.value[i - 1][c] + t * (side.value[i][c] - side.value[i - 1][c]));
  }
  return value;
}

double length_of(const TracedCurve& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < piece_count(curve); ++i) {
    sum += curves::arc_length(curves::piece(curve.control_points, i), 0, 1);
  }
  return sum;
}

}  // namespace sfumato::tracing
