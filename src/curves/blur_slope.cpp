#include "curves/blur_slope.hpp"

#include <algorithm>

#include "curves/attributes.hpp"
#include "curves/front_share.hpp"
#include "curves/stop_parameters.hpp"

namespace sfumato::curves {
namespace {

constexpr double kCodeValues = 255;

float channel(float value, int) {
  return value;
}
float channel(const Rgb& color, int i) {
  return i == 0 ? color.r : i == 1 ? color.g : color.b;
}

/// Returns the largest difference between values of the two sides: 1 where an image decides.
template <class Value>
double largest_step(const SideShader<Value>& left, const SideShader<Value>& right) {
  if (!has_value(left) || !has_value(right)) return 0;
  if (left.stops.empty() || right.stops.empty()) return 1;
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const auto less = [i](const Stop<Value>& a, const Stop<Value>& b) {
      return channel(a.value, i) < channel(b.value, i);
    };
    const auto [l0, l1] = std::ranges::minmax_element(left.stops.stops, less);
    const auto [r0, r1] = std::ranges::minmax_element(right.stops.stops, less);
    largest = std::max({largest, double{channel(l1->value, i)} - double{channel(r0->value, i)},
                        double{channel(r1->value, i)} - double{channel(l0->value, i)}});
  }
  return largest;
}

}  // namespace

BlurSlope::BlurSlope(const Curve& curve, double sharp_radius) : sharp_radius_(sharp_radius) {
  step_ = kCodeValues * std::max(largest_step(curve.left.color, curve.right.color),
                                 largest_step(curve.left.opacity, curve.right.opacity));
  if (step_ == 0) return;
  for (const Side* side : {&curve.left, &curve.right}) {
    if (side->blur_radius.empty()) continue;
    auto& radii = radii_.emplace_back();
    const std::vector<double> at = stop_parameters(curve.control_points, side->blur_radius);
    for (std::size_t i = 0; i < at.size(); ++i) {
      radii.push_back({at[i], static_cast<double>(side->blur_radius.stops[i].value)});
    }
  }
}

double BlurSlope::between(double from, double to) const {
  double slope = 0;
  for (const std::vector<RadiusStop>& stops : radii_) {
    const double radius = radius_at(stops, 0.5 * (from + to));
    if (radius > 0 && radius >= sharp_radius_)
      slope = std::max(slope, kFrontShareSlope * step_ / radius);
  }
  return slope;
}

double BlurSlope::radius_at(const std::vector<RadiusStop>& stops, double parameter) {
  const auto after = std::ranges::upper_bound(stops, parameter, {}, &RadiusStop::parameter);
  if (after == stops.begin()) return stops.front().radius;
  if (after == stops.end()) return stops.back().radius;
  const RadiusStop& before = *(after - 1);
  const double share = (parameter - before.parameter) / (after->parameter - before.parameter);
  return before.radius + share * (after->radius - before.radius);
}

}  // namespace sfumato::curves
