#pragma once

#include <cstdint>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Returns whether replacing `old` by `curve` can raise a document above a limit on sums: of
/// control points, of stops, of shaders that a layer uses.
bool adds_to_sums(const Curve& old, const Curve& curve);

/// Checks a curve as validate() does for a document. Errors and messages: as validate().
Status validate_curve(const Context& context, const Document& document, std::uint32_t layer,
                      std::uint32_t curve);

/// Checks the numbers of curves, control points, stops and used shaders as validate() does. Errors:
/// limit, cancelled. Cost: O(curves).
Status validate_sums(const Context& context, const Document& document);

}  // namespace sfumato
