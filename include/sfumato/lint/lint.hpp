#pragma once

#include <vector>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"
#include "sfumato/lint/hint.hpp"

namespace sfumato {

/// Looks for probable mistakes in a valid document. Returns hints and notes: first those of each
/// layer, then those of the stack, then those of the shaders. What only shows in a picture, such as
/// sides that are never seen and colours that leak, is decided by the same mesh and gather that
/// draw it.
///
/// Errors: as diffuse(). Cost: a mesh of every layer that is painted, and O(log n) a segment.
Result<std::vector<Hint>> lint(Context& context, const Document& document);

}  // namespace sfumato
