#pragma once

#include "formats/css/color.hpp"
#include "formats/svg/input.hpp"

namespace sfumato::svg {

/// The value of a colour property; black if the element has none. currentColor is the element's
/// `color`. Errors: bad_input, cancelled.
Result<css::Color> read_color(Input& input, Element element, css::Property property);

}  // namespace sfumato::svg
