#include "export/page.hpp"

#include <algorithm>
#include <cmath>

#include "document/rules.hpp"

namespace sfumato::outputs {

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}

Status check_viewport(const Box& viewport) {
  if (rules::has_area(viewport)) return ok_status();
  return make_error(StatusCode::bad_input, "a picture with an empty viewport");
}

double points_per_unit(const std::optional<double>& page_width_pt, const Box& viewport) {
  constexpr double kPointsPerCssPixel = 0.75;
  return page_width_pt ? *page_width_pt / viewport.width() : kPointsPerCssPixel;
}

double depth_step(double side, std::size_t count) {
  constexpr double kStep = 1e-3, kMost = 0.1;
  return side * std::min(kStep, kMost / static_cast<double>(count));
}

Page make_page(const Box& viewport, double unit) {
  return {viewport.width() * unit,
          viewport.height() * unit,
          {unit, 0, 0, unit, -viewport.min.x * unit, -viewport.min.y * unit}};
}

}  // namespace sfumato::outputs
