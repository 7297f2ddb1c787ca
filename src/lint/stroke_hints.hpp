#pragma once

#include <cstdint>
#include <vector>

#include "sfumato/document/document.hpp"
#include "sfumato/lint/hint.hpp"

namespace sfumato::lint_detail {

/// Hints about the local curve at a stack item: colours, radius, blur, place.
void check_stroke(const Document& document, std::uint32_t item, const LocalStroke& stroke,
                  std::vector<Hint>& hints);

}  // namespace sfumato::lint_detail
