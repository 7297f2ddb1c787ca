#include "sfumato/document/build.hpp"

#include <utility>

namespace sfumato {

Curve bezier(std::vector<Vec2> control_points) {
  Curve curve;
  curve.control_points = std::move(control_points);
  return curve;
}

Curve polyline(const std::vector<Vec2>& points) {
  Curve curve;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      curve.control_points.push_back(lerp(points[i - 1], points[i], 1.0 / 3));
      curve.control_points.push_back(lerp(points[i - 1], points[i], 2.0 / 3));
    }
    curve.control_points.push_back(points[i]);
  }
  return curve;
}

Side colored(const std::vector<Rgb>& colors, float blur_radius) {
  Side side;
  if (!colors.empty()) {
    side.color.kind = ShaderKind::curve_domain;
    side.color.stops.space = StopSpace::arc_length;
  }
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double offset =
        i == 0 ? 0 : static_cast<double>(i) / static_cast<double>(colors.size() - 1);
    side.color.stops.stops.push_back({offset, colors[i]});
  }
  if (blur_radius != 0) side.blur_radius.stops.push_back({0, blur_radius});
  return side;
}

std::uint32_t add_layer(Document& document, std::vector<Curve> curves, float opacity,
                        BlendMode blend) {
  const auto index = static_cast<std::uint32_t>(document.layers.size());
  document.layers.push_back({{}, std::move(curves)});
  add_instance(document, index, {}, opacity, blend);
  return index;
}

void add_instance(Document& document, std::uint32_t layer, const Affine& artboard_from_layer,
                  float opacity, BlendMode blend) {
  document.stack.push_back(LayerInstance{layer, artboard_from_layer, opacity, blend});
}

}  // namespace sfumato
