#pragma once

#include <cmath>

#include "sfumato/solve/diffuse.hpp"

namespace sfumato::solve {

/// The flattening tolerance of a rough layer, as a multiple of the normal tolerance.
inline constexpr double kRoughness = 4;

/// Returns options for a quick, rough solution, for pictures while something moves. Chords are
/// coarse, and the mesh is refined at blurs only. Gathered values are exact.
/// options   the options of the normal solution, accepted by validate()
DiffuseOptions roughly(const DiffuseOptions& options);

/// Returns whether the options are from roughly(), which sets max_error to infinity. validate()
/// rejects this value.
inline bool is_rough(const DiffuseOptions& options) {
  return std::isinf(options.max_error);
}

/// Returns whether the exact gather decides where the mesh is refined.
inline bool refines(const DiffuseOptions& options) {
  return options.max_error > 0 && !is_rough(options);
}

/// Returns whether the picture is for a pixel grid: chords are coarse, small triangles unrefined.
inline bool is_for_pixel_grid(const DiffuseOptions& options) {
  return options.pixel_grid && refines(options) && !options.tolerance;
}

/// Returns whether dense layers are gathered at the pixels instead of solved.
inline bool may_gather_pixels(const DiffuseOptions& options) {
  return is_for_pixel_grid(options) && options.gather.method == gather::Method::exact;
}

}  // namespace sfumato::solve
