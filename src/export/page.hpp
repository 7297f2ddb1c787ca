#pragma once

#include <optional>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// Where a picture lies on a page, y down, the page's upper left corner at (0, 0).
struct Page {
  double width = 0;  ///< units of the page
  double height = 0;
  Affine page_from_artboard;
};

/// Finite, and above 0.
bool is_positive(double value);

/// Error: bad_input, where a viewport is empty or beyond all coordinates.
Status check_viewport(const Box& viewport);

/// Points (1/72 inch) to a user unit on a page of that width; of its own, three quarters of one, as
/// CSS has it.
double points_per_unit(const std::optional<double>& page_width_pt, const Box& viewport);

/// The page that shows `viewport`, which is not empty, with `unit` page units to a user unit.
Page make_page(const Box& viewport, double unit);

}  // namespace sfumato::outputs
