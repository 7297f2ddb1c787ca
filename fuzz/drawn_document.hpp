#pragma once

#include <optional>

#include "fuzz.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/solve/diffuse.hpp"

namespace sfumato::fuzz {

/// A document that bytes decide on. Bytes that begin with '<' or as gzip does are read as a file
/// (nothing where that fails); others draw a valid document of their own: few curves, but every
/// kind of side, paint, instance and group, with points that coincide or nearly do.
bool is_file(Bytes bytes);
std::optional<Document> drawn_document(Context& context, Bytes bytes);

/// Few enough curves and items to be solved again and again.
bool is_small(const Document& document);

/// Those of a picture of a few pixels.
DiffuseOptions coarse_options(const Document& document);

}  // namespace sfumato::fuzz
