#pragma once

#include "formats/css/color.hpp"
#include "formats/svg/input.hpp"

namespace sfumato::svg {

/// A property that is a colour; black where the element has none. currentColor is the element's
/// `color`. Errors: bad_input, cancelled.
Result<css::Color> read_color(Input& input, Element element, css::Property property);

}  // namespace sfumato::svg
