#pragma once

#include <compare>
#include <cstddef>

#include "import/boundary.hpp"
#include "sfumato/document/shader.hpp"

namespace sfumato::svg_import {

/// Counts of the stops at both ends of a gradient that a region does not show.
struct UnseenStops {
  std::size_t first = 0;
  std::size_t last = 0;

  auto operator<=>(const UnseenStops&) const = default;
};

/// Counts the stops beyond a step at an end of a linear gradient, if no point of the region lies
/// beyond that step. A pixel's colour is a mean over the whole pixel. At an edge of the region that
/// lies on the step, the mean would contain colours that the region does not show. Counts no stops
/// of other gradients.
///
/// tolerance   distance that counts as none, in the boundary's units
UnseenStops unseen_stops(const GradientFill& fill, const Contours& boundary, double tolerance);

}  // namespace sfumato::svg_import
