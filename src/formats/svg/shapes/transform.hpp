#pragma once

#include <string_view>

#include "sfumato/base/affine.hpp"
#include "sfumato/base/context.hpp"
#include "sfumato/base/status.hpp"

namespace sfumato::svg {

/// Reads a transform attribute (SVG 1.1, section 7.6): matrix, translate, scale, rotate, skewX,
/// skewY, from left to right; empty is the identity. Errors: bad_input, without a place; cancelled.
Result<Affine> parse_transform(const Context& context, std::string_view text);

}  // namespace sfumato::svg
