#include "trace/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "sfumato/document/build.hpp"
#include "trace/blur_estimate.hpp"

namespace sfumato::tracing {
namespace {

/// Files are short where numbers are: hundredths of a pixel and of a piece, and colours of 8 bits,
/// are as good as any.
double in_hundredths(double value) {
  return std::round(100 * value) / 100;
}

float in_eight_bits(float value) {
  return std::round(255 * std::clamp(value, 0.0f, 1.0f)) / 255;
}

Side document_side(const SideStops& stops, float radius, bool has_opacity) {
  Side side;
  if (stops.place.empty()) return side;
  side.color.kind = ShaderKind::curve_domain;
  if (has_opacity) side.opacity.kind = ShaderKind::curve_domain;
  for (std::size_t i = 0; i < stops.place.size(); ++i) {
    const auto [r, g, b, alpha] = stops.value[i];
    const double place = in_hundredths(stops.place[i]);
    side.color.stops.stops.push_back(
        {place, {in_eight_bits(r), in_eight_bits(g), in_eight_bits(b)}});
    if (has_opacity) side.opacity.stops.stops.push_back({place, in_eight_bits(alpha)});
  }
  if (radius > 0) side.blur_radius.stops.push_back({0, radius});
  return side;
}

}  // namespace

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
    curve.left = document_side(from.side[0], static_cast<float>(radius), has_opacity);
    curve.right = document_side(from.side[1], static_cast<float>(radius), has_opacity);
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
