#pragma once

#include <cstdint>
#include <vector>

#include "document/document.hpp"
#include "lint/hint.hpp"

namespace sfumato::lint_detail {

/// Hints that the local curve at a stack item gives: colours, radius, blur, place.
void check_stroke(const Document& document, std::uint32_t item, const LocalStroke& stroke,
                  std::vector<Hint>& hints);

}  // namespace sfumato::lint_detail
