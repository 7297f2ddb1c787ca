#pragma once

#include <cstddef>
#include <optional>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/box.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::outputs {

/// The place of a picture on a page, y down; the page's upper left corner is (0, 0).
struct Page {
  double width = 0;  ///< units of the page
  double height = 0;
  Affine page_from_artboard;
};

/// Returns whether it is finite and above 0.
bool is_positive(double value);

/// Error: bad_input, if the viewport is empty or beyond the range of coordinates.
Status check_viewport(const Box& viewport);

/// Error: bad_input, if the page of a viewport, which is not empty, has a side of more than 10^7
/// points.
Status check_page(const Box& viewport, double points_per_unit);

/// Returns by how much an instance enlarges its layer: the largest stretch, as the solver takes it.
/// For a similarity that is the root of the determinant, to the bit; 0 for a map that flattens.
double instance_scale(const Affine& artboard_from_layer);

/// Points (1/72 inch) per user unit on a page of that width; without a width 3/4, as in CSS.
double points_per_unit(const std::optional<double>& page_width_pt, const Box& viewport);

/// By how much one item of a scene lies in front of the one before, where `count` lie on each other
/// and the longer side of the picture is `side`: 1/1000 of it, and all within 1/10.
double depth_step(double side, std::size_t count);

/// The page that shows `viewport`, which is not empty, with `unit` page units per user unit.
Page make_page(const Box& viewport, double unit);

}  // namespace sfumato::outputs
