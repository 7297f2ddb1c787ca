#pragma once

#include <optional>

#include "fuzz.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato::fuzz {

/// A document that bytes decide on. Bytes that begin with '<' or as gzip does are read as a file
/// (nothing where that fails); others draw a valid document of their own: few curves, but every
/// kind of side, paint, instance and group, with points that coincide or nearly do.
bool is_file(Bytes bytes);
std::optional<Document> drawn_document(Context& context, Bytes bytes);

}  // namespace sfumato::fuzz
