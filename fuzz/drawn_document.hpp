#pragma once

#include <optional>

#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::fuzz {

/// Makes a document from bytes. Bytes that begin with '<' or like gzip are read as a file (nothing
/// if that fails). Other bytes draw a valid document: few curves, but every kind of side, paint,
/// instance and group, with points that coincide or nearly coincide.
bool is_file(Bytes bytes);
std::optional<Document> drawn_document(Context& context, Bytes bytes);

/// Returns whether the document has few enough curves and items for many solves.
bool is_small(const Document& document);

/// Returns the options for a picture of a few pixels.
DiffuseOptions coarse_options(const Document& document);

}  // namespace sfumato::fuzz
