#pragma once

#include <cmath>

#include "sfumato/solve/diffuse.hpp"

namespace sfumato::solve {

/// How many times as coarse as those of the picture the chords of a rough layer are.
inline constexpr double kRoughness = 4;

/// How layers are solved roughly that would be solved with `options`, which validate() accepts, for
/// pictures while something moves: from coarse chords, on a mesh that is refined at blurs only.
/// What is gathered is exact.
DiffuseOptions roughly(const DiffuseOptions& options);

/// Whether roughly() gave them: validate() accepts no other options without an end of the error.
inline bool is_rough(const DiffuseOptions& options) {
  return std::isinf(options.max_error);
}

/// Whether the exact gather says where the mesh is to be refined.
inline bool refines(const DiffuseOptions& options) {
  return options.max_error > 0 && !is_rough(options);
}

/// Returns whether chords may be coarse and small triangles stay unrefined, for a pixel grid.
inline bool is_for_pixel_grid(const DiffuseOptions& options) {
  return options.pixel_grid && refines(options) && !options.tolerance;
}

/// Returns whether dense layers are gathered at the pixels instead of solved.
inline bool may_gather_pixels(const DiffuseOptions& options) {
  return is_for_pixel_grid(options) && options.gather.method == gather::Method::exact;
}

}  // namespace sfumato::solve
