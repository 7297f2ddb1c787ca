#include "export/page.hpp"

#include <algorithm>
#include <cmath>

#include "base/largest_scale.hpp"
#include "base/text/number_text.hpp"
#include "document/rules.hpp"

namespace sfumato::outputs {

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}

Status check_viewport(const Box& viewport) {
  if (rules::has_area(viewport)) return ok_status();
  return make_error(StatusCode::bad_input, "a picture with an empty viewport");
}

Status check_page(const Box& viewport, double points_per_unit) {
  constexpr double kMostPoints = 1e7;
  const double width = viewport.width() * points_per_unit;
  const double height = viewport.height() * points_per_unit;
  if (std::max(width, height) <= kMostPoints) return ok_status();
  return make_error(StatusCode::bad_input, "the page would be " + length_text(width) + " x " +
                                               length_text(height) + " points, expected at most " +
                                               length_text(kMostPoints) +
                                               " on a side; use a smaller scale");
}

double instance_scale(const Affine& artboard_from_layer) {
  constexpr double kSimilar = 1 + 1e-6;
  const double mean = std::sqrt(std::fabs(artboard_from_layer.determinant()));
  const double largest = largest_scale(artboard_from_layer);
  return mean == 0 || largest <= kSimilar * mean ? mean : largest;
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
