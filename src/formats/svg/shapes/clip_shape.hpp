#pragma once

#include <string_view>
#include <vector>

#include "formats/css/basic_shape.hpp"
#include "formats/svg/read/input.hpp"
#include "formats/svg/shapes/path.hpp"
#include "sfumato/base/box.hpp"

namespace sfumato::svg {

/// Returns the box to which a basic shape of the element refers, in its user space; empty: it has
/// none. The width of a stroke counts as half of it on each side. Errors: limit, cancelled.
Result<Box> reference_box(Input& input, Element element, css::ReferenceBox box,
                          const Box& viewport);

/// Returns the outline of a basic shape of CSS. `text`: its value, for the points of a polygon. An
/// outline without area is empty. Errors: bad_input, limit, cancelled.
Result<std::vector<Subpath>> basic_shape_outline(Input& input, Element element,
                                                 std::string_view text, bool needs_unit,
                                                 const css::BasicShape& shape, const Box& reference,
                                                 TableMemory& memory);

}  // namespace sfumato::svg
