#include "curves/stop_parameters.hpp"

#include <algorithm>

#include "curves/bezier.hpp"

namespace sfumato::curves {

std::vector<double> cumulative_length(std::span<const Vec2> control_points) {
  return cumulative_length(control_points, [] { return true; });
}

std::vector<double> cumulative_length(std::span<const Vec2> control_points,
                                      FunctionRef<bool()> may_go_on) {
  const std::size_t piece_count = (control_points.size() - 1) / 3;
  std::vector<double> cumulative{0};
  cumulative.reserve(piece_count + 1);
  for (std::size_t i = 0; i < piece_count && may_go_on(); ++i) {
    cumulative.push_back(cumulative.back() + arc_length(piece(control_points, i), 0, 1));
  }
  return cumulative;
}

double parameter_at_fraction(std::span<const Vec2> control_points,
                             std::span<const double> cumulative, double fraction) {
  const std::size_t piece_count = cumulative.size() - 1;
  if (fraction <= 0) return 0;
  if (fraction >= 1) return static_cast<double>(piece_count);
  const double wanted = fraction * cumulative.back();
  const auto after = std::upper_bound(cumulative.begin(), cumulative.end(), wanted);
  const std::size_t i = std::min<std::size_t>(
      static_cast<std::size_t>(after - cumulative.begin()) - 1, piece_count - 1);
  const double within = wanted - cumulative[i];
  return static_cast<double>(i) + parameter_at_length(piece(control_points, i), within);
}

ColorStops in_space(ColorStops list, InterpolationSpace space) {
  if (space == InterpolationSpace::srgb) return list;
  for (Stop<Rgb>& stop : list.stops) stop.value = from_srgb(space, stop.value);
  return list;
}

}  // namespace sfumato::curves
