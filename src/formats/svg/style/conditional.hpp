#pragma once

#include <string_view>

#include "formats/svg/read/input.hpp"

namespace sfumato::svg {

/// Returns whether the conditions of an element let it be drawn (SVG 2, 5.8), for a user who reads
/// English: no extension is known, and systemLanguage names English, whatever the country.
/// requiredFeatures is always fulfilled.
bool meets_conditions(const Input& input, Element element);

/// Returns whether a <switch> chooses such an element if it meets its conditions: the element can
/// be drawn.
bool can_be_chosen(std::string_view element_name);

}  // namespace sfumato::svg
