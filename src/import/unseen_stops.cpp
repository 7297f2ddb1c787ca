#include "import/unseen_stops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sfumato::svg_import {
namespace {

/// The offset of a linear gradient as a function of the plane.
struct LinearOffset {
  double at_origin = 0;
  Vec2 slope;  ///< per unit

  double at(Vec2 p) const { return at_origin + dot(slope, p); }
};

LinearOffset offset_of(const LinearGradient& line, const Affine& layer_from_gradient) {
  const Affine gradient_from_layer = inverse(layer_from_gradient);
  const Vec2 along = line.end - line.start;
  const auto at = [&](Vec2 p) {
    return dot(gradient_from_layer(p) - line.start, along) / length_squared(along);
  };
  const double at_origin = at({0, 0});
  return {at_origin, {at({1, 0}) - at_origin, at({0, 1}) - at_origin}};
}

/// Returns how many stops lie at the offset of the first, without the last one there.
template <class Iterator>
std::size_t stops_before_step(Iterator begin, Iterator end) {
  const auto beyond = std::find_if(
      begin, end, [&](const GradientStop& stop) { return stop.offset != begin->offset; });
  return static_cast<std::size_t>(beyond - begin) - 1;
}

}  // namespace

UnseenStops unseen_stops(const GradientFill& fill, const Contours& boundary, double tolerance) {
  const auto* line = std::get_if<LinearGradient>(&fill.shape);
  if (!line || fill.spread != SpreadMethod::pad || line->start == line->end) return {};
  UnseenStops unseen{stops_before_step(fill.stops.begin(), fill.stops.end()),
                     stops_before_step(fill.stops.rbegin(), fill.stops.rend())};
  if (unseen == UnseenStops{} || unseen.first + 1 == fill.stops.size()) return {};
  const LinearOffset offset = offset_of(*line, fill.layer_from_gradient);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<Vec2>& contour : boundary) {
    for (const Vec2 p : contour) {
      low = std::min(low, offset.at(p));
      high = std::max(high, offset.at(p));
    }
  }
  const double none = tolerance * length(offset.slope);
  if (!(low >= fill.stops.front().offset - none)) unseen.first = 0;
  if (!(high <= fill.stops.back().offset + none)) unseen.last = 0;
  return unseen;
}

}  // namespace sfumato::svg_import
