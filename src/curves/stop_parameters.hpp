#pragma once

#include <span>
#include <vector>

#include "base/table_memory.hpp"
#include "sfumato/base/color_space.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/base/vec2.hpp"
#include "sfumato/document/stops.hpp"

namespace sfumato::curves {

/// Returns the cumulative lengths of a curve's Bézier pieces: entry i is the length before piece i,
/// the last entry the whole length. There is one entry more than pieces.
std::vector<double> cumulative_length(std::span<const Vec2> control_points);

/// Does the same for long chains; the lengths are allocated from `memory`. Errors: limit (memory),
/// cancelled.
Result<std::vector<double>> cumulative_length(const Context& context,
                                              std::span<const Vec2> control_points,
                                              TableMemory& memory);

/// Returns the curve parameter (piece + t) at a fraction 0 to 1 of the curve's length.
double parameter_at_fraction(std::span<const Vec2> control_points,
                             std::span<const double> cumulative, double fraction);

/// Returns colour stops with their values converted to the coordinates of `space`, for
/// interpolation there.
ColorStops in_space(ColorStops list, InterpolationSpace space);
inline const ScalarStops& in_space(const ScalarStops& list, InterpolationSpace) {
  return list;
}

/// Appends the curve parameter of every stop of a list, non-decreasing and clamped to the curve.
///
/// cumulative   cumulative_length() of the points; not used for a list by parameter
template <class Value>
void append_stop_parameters(std::span<const Vec2> control_points,
                            std::span<const double> cumulative, const StopList<Value>& list,
                            std::vector<double>& parameters) {
  const double end = static_cast<double>((control_points.size() - 1) / 3);
  for (const auto& stop : list.stops) {
    double parameter = stop.offset;
    if (list.space == StopSpace::arc_length) {
      parameter = parameter_at_fraction(control_points, cumulative, stop.offset);
    }
    parameter = parameter < 0 ? 0 : parameter > end ? end : parameter;
    if (!parameters.empty() && parameter < parameters.back()) parameter = parameters.back();
    parameters.push_back(parameter);
  }
}

/// Does the same, in a new list.
template <class Value>
std::vector<double> stop_parameters(std::span<const Vec2> control_points,
                                    const StopList<Value>& list) {
  std::vector<double> parameters, cumulative;
  parameters.reserve(list.stops.size());
  if (list.space == StopSpace::arc_length) cumulative = cumulative_length(control_points);
  append_stop_parameters(control_points, cumulative, list, parameters);
  return parameters;
}

}  // namespace sfumato::curves
