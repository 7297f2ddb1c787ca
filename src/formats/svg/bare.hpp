#pragma once

#include <string>

#include "formats/svg/input.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::svg {

/// Why a shape in a layer, which bears no attribute of Sfumato, draws nothing, and what to write:
/// attributes without their prefix, or in style="", are named.
std::string why_bare(Input& input, Element shape);

/// Whether any curve of the document gives a colour.
bool gives_color(const Document& document);

/// Why a document without a colour is an empty picture, and what to write.
struct EmptyCause {
  std::string text;         ///< empty: nothing more than that there is no colour
  bool is_foreign = false;  ///< there is no attribute of Sfumato at all
};

EmptyCause why_empty(Input& input);

}  // namespace sfumato::svg
