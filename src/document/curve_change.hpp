#pragma once

#include <cstdint>

#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"
#include "sfumato/document/document.hpp"

namespace sfumato {

/// Whether `curve` in the place of `old` can bring a document above a limit on sums: of control
/// points, of stops, of shaders that a layer uses.
bool adds_to_sums(const Curve& old, const Curve& curve);

/// What validate() asks of a curve of the document. Errors and messages are those of validate().
Status validate_curve(const Context& context, const Document& document, std::uint32_t layer,
                      std::uint32_t curve);

/// What validate() asks of the numbers of curves, control points, stops and shaders in use.
/// Errors: limit, cancelled. Cost: O(curves).
Status validate_sums(const Context& context, const Document& document);

}  // namespace sfumato
