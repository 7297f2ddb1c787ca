#include "cli/document_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "curves/bezier.hpp"

namespace sfumato::cli {
namespace {

/// Parameters where one coordinate of a cubic, given by its control values, stands still; 2 where
/// there is none (outside [0, 1], so the caller's range check drops it).
std::array<double, 2> still_parameters(double p0, double p1, double p2, double p3) {
  const double a = p3 - 3 * p2 + 3 * p1 - p0;
  const double half_b = p2 - 2 * p1 + p0;
  const double c = p1 - p0;
  const double discriminant = half_b * half_b - a * c;
  if (discriminant < 0) return {2, 2};
  // The stable form: no subtraction of nearly equal numbers, and right where a is 0.
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  return {a != 0 ? q / a : 2, q != 0 ? c / q : 2};
}

bool leaves(const curves::Cubic& cubic, const Box& box) {
  const auto inside = [&box](Vec2 p) { return box.contains(p); };
  if (std::all_of(cubic.begin(), cubic.end(), inside)) return false;  // so is its convex hull
  if (!inside(cubic.front()) || !inside(cubic.back())) return true;
  const auto x = still_parameters(cubic[0].x, cubic[1].x, cubic[2].x, cubic[3].x);
  const auto y = still_parameters(cubic[0].y, cubic[1].y, cubic[2].y, cubic[3].y);
  for (const double t : {x[0], x[1], y[0], y[1]}) {
    if (t > 0 && t < 1 && !inside(curves::point_at(cubic, t))) return true;
  }
  return false;
}

bool is_blurred(const Side& side) {
  return std::any_of(side.blur_radius.stops.begin(), side.blur_radius.stops.end(),
                     [](const Stop<float>& stop) { return stop.value > 0; });
}

}  // namespace

bool leaves(const Curve& curve, const Box& box) {
  for (std::size_t i = 0; i < curve.piece_count(); ++i) {
    if (leaves(curves::piece(curve.control_points, i), box)) return true;
  }
  return false;
}

DocumentFacts count_facts(const Document& document) {
  DocumentFacts facts;
  facts.layers = document.layers.size();
  for (const Layer& layer : document.layers) {
    facts.curves += layer.curves.size();
    for (const Curve& curve : layer.curves) {
      const std::vector<Vec2>& points = curve.control_points;
      facts.closed_curves += !points.empty() && points.front() == points.back();
      facts.bezier_pieces += curve.piece_count();
      facts.control_points += points.size();
      facts.color_stops += curve.left.color.stops.stops.size();
      facts.color_stops += curve.right.color.stops.stops.size();
      facts.blurred_curves += is_blurred(curve.left) || is_blurred(curve.right);
      facts.leaving_curves += leaves(curve, document.artboard);
    }
  }
  return facts;
}

}  // namespace sfumato::cli
