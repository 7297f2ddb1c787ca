#include "curves/stop_slope.hpp"

#include <algorithm>
#include <cmath>

#include "curves/bezier.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

constexpr double kCodesOfStops = 255;

double difference(float a, float b) {
  return std::fabs(double{a} - double{b});
}
double difference(const Rgb& a, const Rgb& b) {
  return std::max({difference(a.r, b.r), difference(a.g, b.g), difference(a.b, b.b)});
}

Vec2 point_of(const Curve& curve, double parameter) {
  const auto last = static_cast<double>(curve.piece_count() - 1);
  const double begin = std::min(std::floor(parameter), last);
  return point_at(piece(curve.control_points, static_cast<std::size_t>(begin)), parameter - begin);
}

}  // namespace

StopSlope::StopSlope(const Curve& curve) {
  for (const Side* side : {&curve.left, &curve.right}) {
    add(curve, side->color.stops);
    add(curve, side->opacity.stops);
  }
}

template <class Value>
void StopSlope::add(const Curve& curve, const StopList<Value>& stops) {
  if (stops.stops.size() < 2) return;
  const std::vector<double> at = stop_parameters(curve.control_points, stops);
  std::vector<Stretch>& stretches = stretches_.emplace_back();
  Vec2 from = point_of(curve, at.front());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Vec2 to = point_of(curve, at[i + 1]);
    const double step = kCodesOfStops * difference(stops.stops[i].value, stops.stops[i + 1].value);
    if (at[i + 1] > at[i] && step > 0) {
      stretches.push_back({at[i], at[i + 1], step / length(to - from)});
    }
    from = to;
  }
}

double StopSlope::between(double from, double to) const {
  double slope = 0;
  for (const std::vector<Stretch>& stretches : stretches_) {
    auto it = std::ranges::upper_bound(stretches, from, {}, &Stretch::to);
    for (; it != stretches.end() && it->from < to; ++it) slope = std::max(slope, it->slope);
  }
  return slope;
}

}  // namespace sfumato::curves
