#pragma once

#include <string_view>

#include "formats/css/color.hpp"
#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// css::parse_color() of the text of an attribute or a property, with a warning for the document's
/// first colour outside sRGB. Errors: bad_input, without a place; cancelled.
Result<css::Color> parse_color(Input& input, Element element, std::string_view attribute,
                               std::string_view text);

/// Warns that `text` is a colour outside sRGB and is mapped into it; once for a document.
void warn_of_mapped(Input& input, Element element, std::string_view attribute,
                    std::string_view text);

/// The value of a colour property; black if the element has none. currentColor is the element's
/// `color`. Errors: bad_input, cancelled.
Result<css::Color> read_color(Input& input, Element element, css::Property property);

}  // namespace sfumato::svg
