#include "formats/svg/totals.hpp"

#include "base/limits.hpp"
#include "document/document.hpp"

namespace sfumato::svg {

Status Totals::add_curve(Element element, std::size_t control_points, std::size_t curve_bytes) {
  if (++curves_ > limits::kCurves) return input_.over_limit(element, limits::kCurves, "curves");
  control_points_ += control_points;
  if (control_points_ > limits::kControlPoints) {
    return input_.over_limit(element, limits::kControlPoints, "control points");
  }
  return input_.charge(element, curve_bytes + control_points * sizeof(Vec2), "the curves");
}

Status Totals::add_stops(Element element, std::size_t count, std::size_t stop_bytes) {
  stops_ += count;
  if (stops_ > limits::kStops) return input_.over_limit(element, limits::kStops, "stops");
  return input_.charge(element, count * stop_bytes, "stops");
}

Status Totals::add_texture(Element element, std::size_t texels) {
  if (++textures_ > limits::kTextures) {
    return input_.over_limit(element, limits::kTextures, "textures");
  }
  texels_ += texels;
  if (texels_ > limits::kTexels) {
    return input_.over_limit(element, limits::kTexels, "texels of textures");
  }
  return input_.charge(element, 4 * texels, "textures");
}

Status Totals::add_stack_item(Element element) {
  if (++stack_items_ > limits::kStackItems) {
    return input_.over_limit(element, limits::kStackItems,
                             "layers, local curves and groups after every use was followed");
  }
  return input_.charge(element, sizeof(StackItem), "the stack");
}

}  // namespace sfumato::svg
