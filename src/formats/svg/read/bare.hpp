#pragma once

#include <string>

#include "formats/svg/read/input.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// Explains why a shape in a layer without attributes of Sfumato draws nothing, and how to fix it.
/// Names attributes without their prefix, or in style="".
std::string why_bare(Input& input, Element shape);

/// Returns whether any curve of the document gives a colour.
bool gives_color(const Document& document);

/// Explains why a document without a colour gives an empty picture, and how to fix it.
struct EmptyCause {
  std::string text;         ///< empty: no cause is known except that there is no colour
  bool is_foreign = false;  ///< there is no attribute of Sfumato at all
};

EmptyCause why_empty(Input& input);

}  // namespace sfumato::svg
