#include "curves/stop_parameters.hpp"

#include <algorithm>

#include "base/poll.hpp"
#include "base/try.hpp"
#include "curves/bezier.hpp"

namespace sfumato::curves {
namespace {

/// Returns the next entry: the length up to the end of piece i.
double next_length(const std::vector<double>& cumulative, std::span<const Vec2> control_points,
                   std::size_t i) {
  return cumulative.back() + arc_length(piece(control_points, i), 0, 1);
}

}  // namespace

std::vector<double> cumulative_length(std::span<const Vec2> control_points) {
  const std::size_t piece_count = (control_points.size() - 1) / 3;
  std::vector<double> cumulative{0};
  cumulative.reserve(piece_count + 1);
  for (std::size_t i = 0; i < piece_count; ++i) {
    cumulative.push_back(next_length(cumulative, control_points, i));
  }
  return cumulative;
}

Result<std::vector<double>> cumulative_length(const Context& context,
                                              std::span<const Vec2> control_points,
                                              TableMemory& memory) {
  const std::size_t piece_count = (control_points.size() - 1) / 3;
  std::vector<double> cumulative;
  SFUMATO_TRY(memory.reserve(context, cumulative, piece_count + 1));
  RarePoll<16> poll(context);
  cumulative.push_back(0);
  for (std::size_t i = 0; i < piece_count; ++i) {
    if (poll.cancelled()) return context.cancel_status();
    cumulative.push_back(next_length(cumulative, control_points, i));
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
