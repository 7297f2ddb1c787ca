#include "formats/svg/read/totals.hpp"

#include "sfumato/base/limits.hpp"

namespace sfumato::svg {

Status Totals::count_curves(Element element, std::size_t curves, std::size_t control_points) {
  curves_ += curves;
  if (curves_ > input_.limits().curves)
    return input_.over_limit(element, &Limits::curves, "curves");
  control_points_ += control_points;
  if (control_points_ > input_.limits().control_points) {
    return input_.over_limit(element, &Limits::control_points, "control points");
  }
  return ok_status();
}

Status Totals::count_stops(Element element, std::size_t count) {
  stops_ += count;
  if (stops_ > input_.limits().stops) return input_.over_limit(element, &Limits::stops, "stops");
  return ok_status();
}

Status Totals::count_texture(Element element, std::size_t texels) {
  if (++textures_ > input_.limits().textures) {
    return input_.over_limit(element, &Limits::textures, "textures");
  }
  texels_ += texels;
  if (texels_ > input_.limits().texels) {
    return input_.over_limit(element, &Limits::texels, "texels of textures");
  }
  return ok_status();
}

Status Totals::count_stack_item(Element element) {
  if (++stack_items_ > input_.limits().stack_items) {
    return input_.over_limit(element, &Limits::stack_items,
                             "layers, local curves and groups after every use was followed");
  }
  return ok_status();
}

}  // namespace sfumato::svg
