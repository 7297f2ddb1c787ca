#pragma once

#include <vector>

#include "formats/svg/input.hpp"
#include "formats/svg/length.hpp"
#include "formats/svg/path.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// A length attribute; `absent` if the element has none. Errors: bad_input.
Result<double> length_of(Input& input, Element element, const char* name, const Box& viewport,
                         Axis axis, double absent);

/// The subpaths of a shape (SVG 2, section 10: basic shapes as their equivalent paths), in its user
/// space, allocated from `memory`. A shape without extent has none. `viewport`: for percentages.
/// Precondition: is_shape(element.name()). Errors: bad_input, limit, cancelled.
Result<std::vector<Subpath>> read_shape(Input& input, Element element, const Box& viewport,
                                        TableMemory& memory);

/// A <rect>; its corner radii are ignored. Errors: bad_input.
Result<Box> read_rect(Input& input, Element element, const Box& viewport);

}  // namespace sfumato::svg
