#pragma once

#include <vector>

#include "formats/svg/read/input.hpp"
#include "formats/svg/shapes/path.hpp"
#include "formats/svg/style/length.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// Returns a length: an attribute, or the property of that name where CSS has one (`x`, `width`,
/// `r` …). `absent` if the element has none, or `auto`. Errors: bad_input.
Result<double> length_of(Input& input, const StyleScope& scope, const char* name,
                         const Box& viewport, Axis axis, double absent);

/// The subpaths of a shape (SVG 2, section 10: basic shapes as their equivalent paths), in its user
/// space, allocated from `memory`. A shape without extent has none. `viewport`: for percentages.
/// Precondition: is_shape(element.name()). Errors: bad_input, limit, cancelled.
Result<std::vector<Subpath>> read_shape(Input& input, const StyleScope& scope, const Box& viewport,
                                        TableMemory& memory);

/// A <rect>; its corner radii are ignored. Errors: bad_input.
Result<Box> read_rect(Input& input, const StyleScope& scope, const Box& viewport);

}  // namespace sfumato::svg
