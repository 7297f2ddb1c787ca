#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/lint/hint.hpp"

namespace sfumato {

/// Finds probable mistakes in a valid document. Returns hints and notes: first about each layer,
/// then about the stack, then about the shaders. Mistakes that only show in a picture, such as
/// sides that are never seen and colours that leak, are found by the same mesh and gather that draw
/// it.
///
/// Errors: as diffuse(). Cost: a mesh of every layer that is painted, and O(log n) a segment.
Result<std::vector<Hint>> lint(Context& context, const Document& document);

}  // namespace sfumato
