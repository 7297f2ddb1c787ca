#pragma once

#include <optional>
#include <string_view>

#include "formats/css/color.hpp"

namespace sfumato::css {

/// Reads a function of colour after its name and up to its closing parenthesis. No value if no
/// such function is read. Errors: bad_input with the cause: "lab() takes no commas; expected
/// lab(50 40 -60), or lab(50 40 -60 / 50%) with an alpha".
std::optional<Result<Color>> take_color_function(Tokenizer& tokens, std::string_view name);

}  // namespace sfumato::css
