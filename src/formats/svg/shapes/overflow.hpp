#pragma once

#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// Returns whether an element with its own viewport clips its content: `overflow`, which is
/// `hidden` by default, as in the style sheet of browsers.
bool hides_overflow(Input& input, Element element);

}  // namespace sfumato::svg
