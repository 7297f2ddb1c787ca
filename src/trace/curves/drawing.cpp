#include "trace/curves/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "sfumato/document/build.hpp"
#include "trace/image/blur_estimate.hpp"

namespace sfumato::tracing {
namespace {

/// How far a step of colours may be moved, pixels.
constexpr double kStepMoves = 0.1;

/// Short numbers make short files: hundredths of a pixel and of a piece, and colours of 8 bits, are
/// precise enough, except for steps of colours on long pieces.
double in_hundredths(double value) {
  return std::round(100 * value) / 100;
}

double step_place(const TracedCurve& curve, double place) {
  const std::size_t pieces = (curve.control_points.size() - 1) / 3;
  const std::size_t first = 3 * std::min(static_cast<std::size_t>(place), pieces - 1);
  double way = 0;
  for (std::size_t i = first; i < first + 3; ++i) {
    way += length(curve.control_points[i + 1] - curve.control_points[i]);
  }
  double places_to_one = 100;
  while (way > 2 * kStepMoves * places_to_one) places_to_one *= 10;
  return std::round(places_to_one * place) / places_to_one;
}

/// In short numbers, and in order.
std::vector<double> short_places(const TracedCurve& curve, std::span<const double> places) {
  const auto is_step = [&](std::size_t i) {
    return (i > 0 && places[i - 1] == places[i]) ||
           (i + 1 < places.size() && places[i] == places[i + 1]);
  };
  std::vector<double> out;
  for (std::size_t i = 0; i < places.size(); ++i) {
    out.push_back(is_step(i) ? step_place(curve, places[i]) : in_hundredths(places[i]));
  }
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (!is_step(i)) out[i] = std::max(out[i], out[i - 1]);
  }
  for (std::size_t i = out.size() - 1; i > 0; --i) {
    if (!is_step(i - 1)) out[i - 1] = std::min(out[i - 1], out[i]);
  }
  return out;
}

Side document_side(const TracedCurve& curve, const SideStops& stops, float radius,
                   bool has_opacity) {
  Side side;
  if (stops.place.empty()) return side;
  const std::vector<double> places = short_places(curve, stops.place);
  side.color.kind = ShaderKind::curve_domain;
  if (has_opacity) side.opacity.kind = ShaderKind::curve_domain;
  for (std::size_t i = 0; i < stops.place.size(); ++i) {
    const auto [r, g, b, alpha] = stops.value[i];
    side.color.stops.stops.push_back(
        {places[i], {in_eight_bits(r), in_eight_bits(g), in_eight_bits(b)}});
    if (has_opacity) side.opacity.stops.stops.push_back({places[i], in_eight_bits(alpha)});
  }
  if (radius > 0) side.blur_radius.stops.push_back({0, radius});
  return side;
}

}  // namespace

float in_eight_bits(float value) {
  return std::round(255 * std::clamp(value, 0.0f, 1.0f)) / 255;
}

std::vector<Curve> document_curves(std::span<const TracedCurve> curves, Vec2 unit_per_pixel,
                                   bool has_opacity) {
  const double unit_of_length = std::sqrt(unit_per_pixel.x * unit_per_pixel.y);
  std::vector<Curve> out;
  out.reserve(curves.size());
  for (const TracedCurve& from : curves) {
    Curve& curve = out.emplace_back();
    curve.control_points.reserve(from.control_points.size());
    for (const Vec2 p : from.control_points) {
      curve.control_points.push_back(
          {in_hundredths(unit_per_pixel.x * p.x), in_hundredths(unit_per_pixel.y * p.y)});
    }
    const double radius =
        from.radius < kSharpRadius ? 0.0 : in_hundredths(from.radius * unit_of_length);
    curve.left = document_side(from, from.side[0], static_cast<float>(radius), has_opacity);
    curve.right = document_side(from, from.side[1], static_cast<float>(radius), has_opacity);
  }
  return out;
}

Document drawing_of(std::span<const TracedCurve> curves, Vec2 size, Vec2 unit_per_pixel,
                    bool has_opacity) {
  Document document;
  document.artboard = {{0, 0}, size};
  add_layer(document, document_curves(curves, unit_per_pixel, has_opacity));
  return document;
}

}  // namespace sfumato::tracing
